package org.selectiverenderer.browser.viewer;

/**
 * Moves the viewer along a recorded path, without collisions and gravity. A path without
 * orientations does not turn the viewer.
 */
public final class PathMotion implements ViewerMotion {
  private final CameraPath path;
  private final double start;

  /**
   * @param start the world's time at which the path's time is 0, in seconds
   */
  public PathMotion(CameraPath path, double start) {
    this.path = path;
    this.start = start;
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    CameraPath.Place place = path.at(time - start);
    viewer.moveTo(place.position());
    place.orientation().ifPresent(viewer::turnTo);
  }
}
