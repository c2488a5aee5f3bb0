/**
 * Packs meshes for the graphics card, on any thread and without GL.
 *
 * <p>In: a {@link org.selectiverenderer.geometry.mesh.Mesh}. Out: a {@link
 * org.selectiverenderer.render.mesh.PackedMesh}, bytes for one vertex and one index buffer, with
 * its triangle clusters for culling; several packed meshes can be merged into one pair of buffers.
 * Uses {@code geometry} and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.render.mesh;

import org.jspecify.annotations.NullMarked;
