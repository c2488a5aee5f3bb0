package org.selectiverenderer.render.window;

import java.util.Optional;

/**
 * The options with which a window is opened.
 *
 * @param width in the desktop's units
 * @param height in the desktop's units
 * @param samples samples per pixel for anti-aliasing; 0 or 1 for none; fewer are used where the
 *     driver offers fewer
 * @param fullScreen whether it opens in full screen; F11 toggles it
 * @param monitor the monitor that it opens on; empty for wherever the desktop puts it
 * @param quadBuffered whether it needs quad-buffered stereo: a left and a right buffer
 */
public record WindowOptions(
    String title,
    int width,
    int height,
    int samples,
    boolean fullScreen,
    Optional<Monitor> monitor,
    boolean quadBuffered) {

  /** Makes options for a window wherever the desktop puts it. */
  public WindowOptions(String title, int width, int height, int samples, boolean fullScreen) {
    this(title, width, height, samples, fullScreen, Optional.empty(), false);
  }

  /** Returns options for a window that fills a monitor. */
  public static WindowOptions filling(Monitor monitor, String title, int samples) {
    return new WindowOptions(
        title, monitor.width(), monitor.height(), samples, true, Optional.of(monitor), false);
  }

  /** Returns the same options with quad-buffered stereo. */
  public WindowOptions withQuadBuffers() {
    return new WindowOptions(title, width, height, samples, fullScreen, monitor, true);
  }
}
