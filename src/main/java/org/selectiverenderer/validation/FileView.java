package org.selectiverenderer.validation;

import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.SceneDocument;
import org.selectiverenderer.x3d.X3dFile;

/**
 * What a {@link FileCheck} sees.
 *
 * @param document all elements and attributes with their places; {@link SceneDocument#broken()}
 *     where it ends too early
 * @param scene the nodes made of it, prototypes expanded, names and routes resolved; a node's
 *     {@code location()} is that of its element
 */
public record FileView(NodeCatalogue catalogue, SceneDocument document, X3dFile scene) {}
