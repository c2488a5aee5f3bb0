package org.selectiverenderer.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.mesh.RefinementLevelRange;
import org.selectiverenderer.render.mesh.TriangleClusters;
import org.selectiverenderer.render.occlusion.MeshOccluders;

/**
 * The part of an index buffer that a shape draws.
 *
 * @param clusters the clusters of that part, in the coordinates of the buffers
 * @param coarser the coarser refinement levels, fewest triangles first
 * @param occluders the flat parts that hide other things, in the coordinates of the buffers
 * @param batch the batch that owns the buffers, or null for the mesh's own buffers
 * @param merged the shape's {@code world()} when it was put into the batch, or null without a batch
 */
record SubMesh(
    GpuMesh mesh,
    TriangleClusters clusters,
    List<RefinementLevelRange> coarser,
    MeshOccluders occluders,
    @Nullable DrawBatch batch,
    @Nullable Matrix4dc merged) {

  /** Returns the whole of a mesh's own buffers. */
  static SubMesh whole(GpuMesh mesh, MeshOccluders occluders) {
    return new SubMesh(mesh, mesh.clusters(), mesh.coarser(), occluders, null, null);
  }

  /** Returns whether the shape still has the place that its batch was made for. */
  boolean holds(ShapeInstance shape) {
    return merged == null || merged == shape.world() || merged.equals(shape.world());
  }

  /** Returns the matrix from the coordinates in the buffers to the world, for this shape. */
  Matrix4dc place(ShapeInstance shape) {
    return batch == null ? shape.world() : batch.place();
  }
}
