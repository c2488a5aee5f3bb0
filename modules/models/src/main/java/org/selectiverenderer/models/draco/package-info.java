/**
 * Decodes meshes that Draco has compressed, as KHR_draco_mesh_compression of glTF has them, in a
 * child process.
 *
 * <p>The library Drako decodes what Google's encoder writes, but damaged bytes make it loop without
 * an end or ask for any amount of memory. {@link org.selectiverenderer.models.draco.DracoProcess}
 * starts the child, limits its time and memory, and checks what it answers; {@link
 * org.selectiverenderer.models.draco.DracoMain} is the child's main class.
 *
 * <p>Uses {@code base.platform} and Drako.
 */
@NullMarked
package org.selectiverenderer.models.draco;

import org.jspecify.annotations.NullMarked;
