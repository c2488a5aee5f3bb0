/**
 * Lit scenes as X3D files: the scene as it was, its shapes with colours at their vertices and no
 * lit material, its lights off, every Inline with a file of its own.
 *
 * <p>In: a scene's instance tree and a {@link org.selectiverenderer.radiosity.bake.LitScene}. Out:
 * texts by file. Uses {@code radiosity.bake}, {@code radiosity.mesh} and {@code radiosity.scene},
 * {@code runtime}, {@code polygon.model}'s urls, {@code geometry.mesh}, {@code x3d} and {@code
 * base}.
 */
@NullMarked
package org.selectiverenderer.radiosity.output;

import org.jspecify.annotations.NullMarked;
