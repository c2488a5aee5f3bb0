/**
 * Hierarchies of boxes: which of many things a ray or a box may meet, without asking each.
 *
 * <p>In: the boxes of numbered items, or a mesh. Out: their numbers; where a ray meets the mesh.
 * Uses {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.geometry.tree;

import org.jspecify.annotations.NullMarked;
