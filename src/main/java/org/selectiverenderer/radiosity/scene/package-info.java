/**
 * A loaded scene as the light sees it: triangles with reflectance and emission, and lamps.
 *
 * <p>In: the instance tree of a scene as it is when loaded. Out: {@link
 * org.selectiverenderer.radiosity.scene.LightScene}, or the one sentence why there can be none.
 * Uses {@code runtime.instance}, {@code runtime.scene}, {@code x3d.geometry} and {@code
 * radiosity.trace} and {@code radiosity.light}.
 */
@NullMarked
package org.selectiverenderer.radiosity.scene;

import org.jspecify.annotations.NullMarked;
