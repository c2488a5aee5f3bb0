/**
 * What lives on the graphics card: programs, buffers, textures. Every call needs the context to be
 * current on the calling thread.
 *
 * <p>A plain surface is a {@link ShapeVariant} of the shape shader. A detailed one adds defines of
 * its own ({@link DetailDefines}), which name its textures and what they are for, and is told the
 * rest by {@link DetailTextures}.
 *
 * <p>In: packed meshes, images, shader texts from the resources. Out: GL objects, each with a
 * {@code dispose}. Uses {@code runtime.render.mesh}, {@code runtime.render.glsl}, {@code
 * runtime.instance}, {@code geometry.mesh} and JOGL.
 */
@NullMarked
package org.selectiverenderer.runtime.render.gpu;

import org.jspecify.annotations.NullMarked;
