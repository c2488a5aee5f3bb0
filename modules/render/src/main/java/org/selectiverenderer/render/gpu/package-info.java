/**
 * The GL objects on the graphics card: shader programs, buffers, textures. Every call needs the
 * context to be current on the calling thread.
 *
 * <p>A plain surface is a {@link ShaderVariant} of the shape shader. A surface with several
 * textures adds defines ({@link MaterialDefines}), which name its textures and their roles, and has
 * its uniforms in {@link MaterialBinding}.
 *
 * <p>In: packed meshes, images, shader sources from the resources. Out: GL objects, each with a
 * {@code dispose}. Uses {@code render.mesh}, {@code render.glsl}, {@code browser.instance}, {@code
 * geometry.mesh} and JOGL.
 */
@NullMarked
package org.selectiverenderer.render.gpu;

import org.jspecify.annotations.NullMarked;
