/**
 * Rays against all triangles of a scene. In: triangles in world coordinates, each with the version
 * of an object that it belongs to. Out: what a ray meets first and how much light passes between
 * two points. Uses the box trees of {@code runtime.navigation}.
 */
@NullMarked
package org.selectiverenderer.radiosity.trace;

import org.jspecify.annotations.NullMarked;
