package org.selectiverenderer.runtime.render.mesh;

import java.nio.ByteBuffer;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A mesh as the bytes of one vertex and one index buffer, both direct and in native order.
 *
 * @param wideIndices whether an index takes four bytes, else two
 * @param indexCount number of indices, three, two or one per primitive, those of all stages
 * @param clusters the triangles' clusters; lines and points are one cluster that is never culled
 * @param coarser the stages before, fewest triangles first; they stand behind in the index buffer
 */
public record PackedMesh(
    Mesh.Primitive primitive,
    boolean solid,
    VertexLayout layout,
    ByteBuffer vertices,
    ByteBuffer indices,
    boolean wideIndices,
    int indexCount,
    Clusters clusters,
    List<CoarserPart> coarser) {

  /** Bytes per index. */
  public int indexBytes() {
    return wideIndices ? 4 : 2;
  }
}
