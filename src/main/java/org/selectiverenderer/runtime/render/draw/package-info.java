/**
 * Draws an instance tree into the current frame buffer, as one camera sees it.
 *
 * <p>In: an {@link org.selectiverenderer.runtime.instance.InstanceTree} and a camera. Out: pixels,
 * by {@link org.selectiverenderer.runtime.render.draw.SceneRenderer}: what is in the frustum,
 * sorted, with its lights. What lives on the graphics card is {@code runtime.render.gpu}'s. Uses
 * it, {@code runtime.render.light}, {@code runtime.render.mesh}, {@code runtime.render.context},
 * {@code runtime.instance}, {@code runtime.camera}, {@code geometry.mesh} and JOGL.
 */
@NullMarked
package org.selectiverenderer.runtime.render.draw;

import org.jspecify.annotations.NullMarked;
