/**
 * Draws the preview pictures of an editor: the scene with boxes around what is selected.
 *
 * <p>A picture of a scene that differs little from the previous one is made from that: {@code
 * PictureDamage} finds the part that differs, and only that is drawn.
 *
 * <p>In: a world, a camera, a {@link org.selectiverenderer.render.preview.PreviewOptions}. Out:
 * {@link org.selectiverenderer.render.preview.PreviewImage}s. Uses {@code browser}, {@code
 * browser.instance}, {@code browser.camera}, the renderer's {@code context}, {@code draw}, {@code
 * gpu} and {@code mesh}, and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.render.preview;

import org.jspecify.annotations.NullMarked;
