package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.mesh.Clusters;
import org.selectiverenderer.runtime.render.mesh.CoarserPart;
import org.selectiverenderer.runtime.render.occlude.Occluders;

/**
 * A shape's stretch of an index buffer.
 *
 * @param clusters of the stretch, in the coordinates of the buffers
 * @param coarser stretches that draw the same with fewer triangles, the fewest first
 * @param occluders what of the stretch hides other things, in the coordinates of the buffers
 * @param batch whose buffers they are, or null for the mesh's own
 * @param merged the shape's {@code world()} when it was put into the batch, or null without one
 */
record MeshPart(
    GpuMesh mesh,
    Clusters clusters,
    List<CoarserPart> coarser,
    Occluders occluders,
    @Nullable DrawBatch batch,
    @Nullable Matrix4dc merged) {

  /** All of a mesh's own buffers. */
  static MeshPart whole(GpuMesh mesh, Occluders occluders) {
    return new MeshPart(mesh, mesh.clusters(), mesh.coarser(), occluders, null, null);
  }

  /** Whether the shape still stands where its buffers say. */
  boolean holds(ShapeInstance shape) {
    return merged == null || merged == shape.world() || merged.equals(shape.world());
  }

  /** From the coordinates of the buffers to the world, for this shape. */
  Matrix4dc place(ShapeInstance shape) {
    return batch == null ? shape.world() : batch.place();
  }
}
