/**
 * Rays against all triangles of a scene.
 *
 * <p>In: triangles in world coordinates, each with the version of an object that it belongs to.
 * Out: what a ray meets first and how much light passes between two points. Uses {@code geometry}
 * and the box trees of {@code geometry.tree}.
 */
@NullMarked
package org.selectiverenderer.radiosity.trace;

import org.jspecify.annotations.NullMarked;
