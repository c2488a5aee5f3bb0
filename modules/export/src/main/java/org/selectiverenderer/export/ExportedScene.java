package org.selectiverenderer.export;

import java.util.Optional;
import org.selectiverenderer.authoring.packaging.ScenePackage;

/**
 * A scene that needs nothing of this program.
 *
 * @param files the scene and all that it names
 * @param controller DEF name of the Script that sets the choices; empty without one
 * @param title the scene's title for people: that of its head, or else its file name
 */
public record ExportedScene(ScenePackage files, Optional<String> controller, String title) {}
