package org.selectiverenderer.browser.viewer;

/** Moves the viewer, frame by frame: a walker, a recorded path, a change of viewpoint. */
@FunctionalInterface
public interface ViewerMotion {
  /**
   * Moves the viewer for a frame.
   *
   * @param time the frame's time in seconds
   * @param dt the seconds since the frame before; 0 in the first frame
   */
  void move(Viewer viewer, double time, double dt);
}
