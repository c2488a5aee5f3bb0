/**
 * Small preview images of the light while it is computed, by ray casting.
 *
 * <p>In: a scene and its light so far. Out: the bytes of a PNG file. Uses {@code radiosity.atlas},
 * {@code radiosity.bake}, {@code radiosity.mesh}, {@code radiosity.scene}, {@code radiosity.solve},
 * {@code radiosity.texel}, {@code radiosity.trace}, {@code browser}, {@code x3d.catalogue} and
 * {@code formats.image}.
 */
@NullMarked
package org.selectiverenderer.radiosity.preview;

import org.jspecify.annotations.NullMarked;
