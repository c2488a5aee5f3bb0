package org.selectiverenderer.render.display;

import java.util.Optional;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.window.WindowOptions;

/**
 * The windows of a run and the way in which they are drawn.
 *
 * @param main the participant's window, or the left eye's
 * @param layout the views in the main window, or over both eyes' windows side by side
 * @param style the options for drawing the world
 * @param rightEye the right eye's own window, if there are two
 * @param operator the experimenter's window
 * @param pictureSamples samples per pixel of the last picture, which is drawn once more if these
 *     are more than the main window's
 */
public record WindowSetup(
    WindowOptions main,
    ViewLayout layout,
    RenderOptions style,
    Optional<WindowOptions> rightEye,
    Optional<WindowOptions> operator,
    int pictureSamples) {}
