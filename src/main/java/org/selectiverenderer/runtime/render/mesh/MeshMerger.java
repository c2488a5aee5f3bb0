package org.selectiverenderer.runtime.render.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;

/**
 * Puts packed meshes behind one another into the buffers of one. Stateless; safe for use by several
 * threads.
 */
public final class MeshMerger {
  /** Vertices that the meshes merged into one may have together: indices stay two bytes wide. */
  public static final int MOST_VERTICES = MeshPacker.SHORT_INDEX_VERTICES;

  private MeshMerger() {}

  /**
   * Several meshes in one pair of buffers.
   *
   * @param mesh the buffers; as a whole it is one cluster that is never culled
   * @param parts of each mesh, in the order given, the clusters with its place in the index buffer
   */
  public record Merged(PackedMesh mesh, List<Clusters> parts) {}

  /**
   * Merges meshes of one primitive, layout and solidity.
   *
   * @param meshes at least one, with at most {@link #MOST_VERTICES} vertices together
   * @throws IllegalArgumentException if they cannot be one mesh
   */
  public static Merged merge(List<PackedMesh> meshes) {
    PackedMesh first = meshes.get(0);
    int vertexBytes = 0;
    int indexCount = 0;
    for (PackedMesh mesh : meshes) {
      if (mesh.primitive() != first.primitive()
          || !mesh.layout().equals(first.layout())
          || mesh.solid() != first.solid()) {
        throw new IllegalArgumentException("meshes that differ in kind are not merged");
      }
      vertexBytes += mesh.vertices().limit();
      indexCount += mesh.indexCount();
    }
    int stride = first.layout().stride();
    if (vertexBytes / stride > MOST_VERTICES) {
      throw new IllegalArgumentException(
          "merged meshes have at most %d vertices, not %d"
              .formatted(MOST_VERTICES, vertexBytes / stride));
    }
    ByteBuffer vertices = direct(vertexBytes);
    ByteBuffer indices = direct(2 * indexCount);
    List<Clusters> parts = new ArrayList<>(meshes.size());
    for (PackedMesh mesh : meshes) {
      parts.add(mesh.clusters().from(indices.position() / 2));
      int base = vertices.position() / stride;
      for (int i = 0; i < mesh.indexCount(); i++) {
        indices.putShort((short) (base + mesh.indices().getShort(2 * i)));
      }
      vertices.put(mesh.vertices().duplicate());
    }
    PackedMesh merged =
        new PackedMesh(
            first.primitive(),
            first.solid(),
            first.layout(),
            vertices.flip(),
            indices.flip(),
            false,
            indexCount,
            Clusters.whole(indexCount));
    return new Merged(merged, parts);
  }

  private static ByteBuffer direct(int bytes) {
    return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
  }
}
