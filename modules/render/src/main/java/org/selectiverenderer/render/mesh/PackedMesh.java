package org.selectiverenderer.render.mesh;

import java.nio.ByteBuffer;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A mesh as the bytes of one vertex and one index buffer, both direct and in native byte order.
 *
 * @param wideIndices whether an index takes four bytes, else two
 * @param indexCount the number of indices of all refinement levels: three per triangle, two per
 *     line, one per point
 * @param clusters the clusters of the finest level; lines and points are one cluster that is never
 *     culled
 * @param coarser the coarser levels, fewest triangles first, which follow in the index buffer
 */
public record PackedMesh(
    Mesh.Primitive primitive,
    boolean solid,
    VertexLayout layout,
    ByteBuffer vertices,
    ByteBuffer indices,
    boolean wideIndices,
    int indexCount,
    TriangleClusters clusters,
    List<RefinementLevelRange> coarser) {

  /** Bytes per index. */
  public int indexBytes() {
    return wideIndices ? 4 : 2;
  }
}
