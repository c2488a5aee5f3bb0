/**
 * Lit scenes as X3D files: the original scene graph, every instance of an Inline with a file of its
 * own, and its shapes as a {@link org.selectiverenderer.radiosity.output.LitSceneFormat} writes
 * them: with lightmaps, and with highlights by lights that stay on, or with colours at their
 * vertices and lights off.
 *
 * <p>In: a scene's instance tree and its light. Out: X3D texts and images by file. Uses {@code
 * radiosity.atlas}, {@code radiosity.bake}, {@code radiosity.light}, {@code radiosity.mesh}, {@code
 * radiosity.scene} and {@code radiosity.trace}, {@code formats.image}, {@code browser}, {@code
 * models}'s urls, {@code geometry.mesh}, {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.radiosity.output;

import org.jspecify.annotations.NullMarked;
