package org.selectiverenderer.app.settings;

import java.nio.file.Path;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * The scene of a run and how it is loaded.
 *
 * @param file file of the scene
 * @param rendering the condition and its random seed
 * @param access the files and URLs that the scene may load besides those in its folder
 * @param muted whether its sounds are off
 */
public record SceneSettings(
    Path file, SelectiveController.Settings rendering, ContentAccessPolicy access, boolean muted) {}
