/**
 * Access to schema metadata in nodes of files and of the embedded browser's scene.
 *
 * <p>In: nodes as {@link org.selectiverenderer.x3d.catalogue.NodeView}s. Out: {@link
 * org.selectiverenderer.polygon.metadata.NodeViewMetadata}, for the readers of {@code schema}. A
 * package of its own, so that the controller, which accesses nodes through the SAI, needs no node
 * catalogue. Uses {@code schema} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.polygon.metadata;

import org.jspecify.annotations.NullMarked;
