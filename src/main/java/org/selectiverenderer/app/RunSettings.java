package org.selectiverenderer.app;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.MouseMapping;

/**
 * What a run shows and for how long.
 *
 * @param path the recorded path that the viewer follows; empty when the user walks
 * @param duration seconds after which the run ends by itself
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param samples per pixel for anti-aliasing, 0 for none; empty for what suits the machine
 * @param mouse what the mouse buttons do
 * @param presentation to one eye or two, and on what
 * @param pathFrames whether the frames are the path's own rows, as those of a session played again;
 *     else {@value #PATH_RATE} per second
 * @param head its tracker and its log
 * @param operator whether there is a window for whoever runs the session
 */
public record RunSettings(
    Path scene,
    SelectiveController.Settings rendering,
    Optional<CameraPath> path,
    OptionalDouble duration,
    int width,
    int height,
    OptionalInt samples,
    MouseMapping mouse,
    Presentation presentation,
    boolean pathFrames,
    HeadSettings head,
    boolean operator) {
  /** Frames per second of a recorded path's time. */
  public static final double PATH_RATE = 60;
}
