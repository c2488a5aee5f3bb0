/**
 * Ray casting: intersections of rays with all triangles of a scene.
 *
 * <p>In: triangles in world coordinates, each with the version of an object that it belongs to.
 * Out: the first hit of a ray, and the share of light that passes between two points. Uses {@code
 * geometry} and the box trees of {@code geometry.bvh}.
 */
@NullMarked
package org.selectiverenderer.radiosity.trace;

import org.jspecify.annotations.NullMarked;
