package org.selectiverenderer.runtime.render.window;

import java.util.Optional;

/**
 * How a window is opened.
 *
 * @param width in the desktop's units
 * @param height in the desktop's units
 * @param samples per pixel for anti-aliasing; 0 or 1 for none; fewer are taken where there are
 *     fewer
 * @param fullScreen whether it opens over the whole screen; F11 changes it
 * @param monitor that it opens on; empty for wherever the desktop puts it
 * @param quadBuffered whether it is to have a left and a right buffer
 */
public record WindowOptions(
    String title,
    int width,
    int height,
    int samples,
    boolean fullScreen,
    Optional<Monitor> monitor,
    boolean quadBuffered) {

  /** A window wherever the desktop puts it. */
  public WindowOptions(String title, int width, int height, int samples, boolean fullScreen) {
    this(title, width, height, samples, fullScreen, Optional.empty(), false);
  }

  /** The whole of a monitor. */
  public static WindowOptions filling(Monitor monitor, String title, int samples) {
    return new WindowOptions(
        title, monitor.width(), monitor.height(), samples, true, Optional.of(monitor), false);
  }

  /** The same with a left and a right buffer. */
  public WindowOptions withQuadBuffers() {
    return new WindowOptions(title, width, height, samples, fullScreen, monitor, true);
  }
}
