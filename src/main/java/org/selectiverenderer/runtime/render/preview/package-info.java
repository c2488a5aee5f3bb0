/**
 * Draws the preview pictures of an editor: the scene with boxes around what is selected.
 *
 * <p>In: a world, a camera, a {@link org.selectiverenderer.runtime.render.preview.PreviewOptions}.
 * Out: {@link org.selectiverenderer.runtime.render.preview.PreviewImage}s. Uses {@code runtime},
 * {@code runtime.instance}, {@code runtime.camera}, the renderer's {@code context}, {@code draw},
 * {@code gpu} and {@code mesh}, and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.preview;

import org.jspecify.annotations.NullMarked;
