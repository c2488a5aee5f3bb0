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
   * @param parts of each mesh, in the order given, where it is in the index buffer
   */
  public record Merged(PackedMesh mesh, List<Part> parts) {}

  /**
   * What a mesh has in the buffers.
   *
   * @param clusters of its last stage
   * @param coarser its stages before, fewest triangles first
   */
  public record Part(Clusters clusters, List<CoarserPart> coarser) {}

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
    List<Part> parts = new ArrayList<>(meshes.size());
    int[] bases = new int[meshes.size()];
    int stages = 0;
    for (int m = 0; m < bases.length; m++) {
      PackedMesh mesh = meshes.get(m);
      bases[m] = vertices.position() / stride;
      parts.add(new Part(copy(mesh, mesh.clusters(), bases[m], indices), new ArrayList<>()));
      vertices.put(mesh.vertices().duplicate());
      stages = Math.max(stages, mesh.coarser().size());
    }
    // Neighbours in the same stage are one stretch.
    for (int stage = 0; stage < stages; stage++) {
      for (int m = 0; m < bases.length; m++) {
        if (stage < meshes.get(m).coarser().size()) {
          CoarserPart part = meshes.get(m).coarser().get(stage);
          Clusters moved = copy(meshes.get(m), part.clusters(), bases[m], indices);
          parts.get(m).coarser().add(new CoarserPart(moved, part.undivided()));
        }
      }
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
            Clusters.whole(indexCount),
            List.of());
    return new Merged(merged, parts);
  }

  /** Appends a stretch of a mesh's indices, and tells where it is now. */
  private static Clusters copy(PackedMesh mesh, Clusters clusters, int base, ByteBuffer out) {
    Clusters moved = clusters.from(out.position() / 2);
    int from = clusters.firstIndex()[0];
    for (int i = from; i < from + clusters.indexCount(); i++) {
      out.putShort((short) (base + mesh.indices().getShort(2 * i)));
    }
    return moved;
  }

  private static ByteBuffer direct(int bytes) {
    return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
  }
}
