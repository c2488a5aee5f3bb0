package org.selectiverenderer.render.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;

/**
 * Concatenates packed meshes into one vertex and one index buffer. Stateless; safe for use by
 * several threads.
 */
public final class MeshMerger {
  /**
   * The most vertices that merged meshes may have together, so that indices stay two bytes wide.
   */
  public static final int MOST_VERTICES = MeshPacker.SHORT_INDEX_VERTICES;

  private MeshMerger() {}

  /**
   * Several meshes in one pair of buffers.
   *
   * @param mesh the merged buffers, as one cluster that is never culled
   * @param parts the index ranges of each mesh, in the order given
   */
  public record Merged(PackedMesh mesh, List<Part> parts) {}

  /**
   * The index ranges of one mesh in the merged buffers.
   *
   * @param clusters the clusters of its finest refinement level
   * @param coarser its coarser levels, fewest triangles first
   */
  public record Part(TriangleClusters clusters, List<RefinementLevelRange> coarser) {}

  /**
   * Merges meshes of one primitive, layout and solidity.
   *
   * @param meshes at least one, with at most {@link #MOST_VERTICES} vertices together
   * @throws IllegalArgumentException if the meshes cannot be one mesh
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
    // The same level of neighbouring meshes is one contiguous range.
    for (int stage = 0; stage < stages; stage++) {
      for (int m = 0; m < bases.length; m++) {
        if (stage < meshes.get(m).coarser().size()) {
          RefinementLevelRange part = meshes.get(m).coarser().get(stage);
          TriangleClusters moved = copy(meshes.get(m), part.clusters(), bases[m], indices);
          parts.get(m).coarser().add(new RefinementLevelRange(moved, part.undivided()));
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
            TriangleClusters.whole(indexCount),
            List.of());
    return new Merged(merged, parts);
  }

  /** Appends a range of a mesh's indices, and returns its clusters at their new place. */
  private static TriangleClusters copy(
      PackedMesh mesh, TriangleClusters clusters, int base, ByteBuffer out) {
    TriangleClusters moved = clusters.from(out.position() / 2);
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
