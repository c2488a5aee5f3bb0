/**
 * A loaded scene prepared for light transport: triangles with reflectance and emission, and lamps.
 *
 * <p>In: the instance tree of a scene as it is when loaded. Out: {@link
 * org.selectiverenderer.radiosity.scene.RadiosityScene}, or the one sentence why there can be none.
 * Uses {@code radiosity.light}, {@code radiosity.trace}, {@code browser}, {@code schema}, {@code
 * geometry.mesh}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.radiosity.scene;

import org.jspecify.annotations.NullMarked;
