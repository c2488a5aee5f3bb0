/**
 * The vocabulary in nodes of files and of the embedded browser's scene.
 *
 * <p>In: nodes, seen through {@link org.selectiverenderer.x3d.catalogue.NodeView}. Out: {@link
 * org.selectiverenderer.schema.nodes.NodeMetadata}, for the readers of {@code schema}. Apart from
 * it, so that the controller, which sees nodes through the SAI, needs no catalogue of X3D's nodes.
 * Uses {@code schema} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.schema.nodes;

import org.jspecify.annotations.NullMarked;
