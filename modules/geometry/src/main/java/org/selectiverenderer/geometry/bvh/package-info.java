/**
 * Bounding volume hierarchies, and the ray, box and closest-point queries on meshes that use them.
 *
 * <p>In: the boxes of numbered items, or a mesh. Out: items found; intersections of rays with a
 * mesh. Uses {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.geometry.bvh;

import org.jspecify.annotations.NullMarked;
