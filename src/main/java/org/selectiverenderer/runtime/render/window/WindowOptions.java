package org.selectiverenderer.runtime.render.window;

/**
 * How a window is opened.
 *
 * @param width in the desktop's units
 * @param height in the desktop's units
 * @param samples per pixel for anti-aliasing; 0 or 1 for none; fewer are taken where there are
 *     fewer
 * @param fullScreen whether it opens over the whole screen; F11 changes it
 */
public record WindowOptions(String title, int width, int height, int samples, boolean fullScreen) {

  /** A window with four samples per pixel. */
  public static WindowOptions of(String title, int width, int height) {
    return new WindowOptions(title, width, height, 4, false);
  }
}
