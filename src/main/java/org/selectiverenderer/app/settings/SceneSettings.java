package org.selectiverenderer.app.settings;

import java.nio.file.Path;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * What is shown.
 *
 * @param file of the scene
 * @param rendering the condition and its lot
 * @param access what the scene may name besides its own files
 * @param muted whether its sounds are not heard
 */
public record SceneSettings(
    Path file, SelectiveController.Settings rendering, ContentAccess access, boolean muted) {}
