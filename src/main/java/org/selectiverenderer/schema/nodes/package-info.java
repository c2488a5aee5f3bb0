/**
 * Access to schema metadata in nodes of files and of the embedded browser's scene.
 *
 * <p>In: nodes as {@link org.selectiverenderer.x3d.catalogue.NodeView}s. Out: {@link
 * org.selectiverenderer.schema.nodes.NodeViewMetadata}, for the readers of {@code schema}. A
 * package of its own, so that the controller, which accesses nodes through the SAI, needs no node
 * catalogue. Uses {@code schema} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.schema.nodes;

import org.jspecify.annotations.NullMarked;
