package org.selectiverenderer.app;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.MouseMapping;

/**
 * What a run shows and for how long.
 *
 * @param path the recorded path that the viewer follows; empty when the user walks
 * @param duration seconds after which the run ends by itself
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param mouse what the mouse buttons do
 */
public record RunSettings(
    Path scene,
    SelectiveController.Settings rendering,
    Optional<CameraPath> path,
    OptionalDouble duration,
    int width,
    int height,
    MouseMapping mouse) {
  /** Frames per second of a recorded path's time. */
  public static final double PATH_RATE = 60;

  /** Samples per pixel for anti-aliasing in windows and pictures. */
  public static final int SAMPLES = 4;
}
