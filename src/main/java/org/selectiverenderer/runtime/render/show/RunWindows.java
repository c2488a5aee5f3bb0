package org.selectiverenderer.runtime.render.show;

import java.util.Optional;
import org.selectiverenderer.runtime.camera.ViewLayout;
import org.selectiverenderer.runtime.render.DrawStyle;
import org.selectiverenderer.runtime.render.window.WindowOptions;

/**
 * The windows of a run.
 *
 * @param main the participant's window, or the left eye's
 * @param layout the views in the main window, or over both eyes' windows side by side
 * @param style how the world is drawn
 * @param rightEye a window for the right eye alone
 * @param operator a window for whoever runs the session
 */
public record RunWindows(
    WindowOptions main,
    ViewLayout layout,
    DrawStyle style,
    Optional<WindowOptions> rightEye,
    Optional<WindowOptions> operator) {}
