/**
 * Meshes made ready for the graphics card, on any thread and without GL.
 *
 * <p>In: a {@link org.selectiverenderer.geometry.mesh.Mesh}. Out: a {@link
 * org.selectiverenderer.runtime.render.mesh.PackedMesh}, bytes for one vertex and one index buffer,
 * and its clusters for culling; several of them in one pair of buffers. Uses {@code geometry} and
 * {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.mesh;

import org.jspecify.annotations.NullMarked;
