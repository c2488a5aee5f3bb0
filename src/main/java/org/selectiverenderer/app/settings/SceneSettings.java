package org.selectiverenderer.app.settings;

import java.nio.file.Path;
import org.selectiverenderer.control.SelectiveController;

/**
 * What is shown.
 *
 * @param file of the scene
 * @param rendering the condition and its lot
 */
public record SceneSettings(Path file, SelectiveController.Settings rendering) {}
