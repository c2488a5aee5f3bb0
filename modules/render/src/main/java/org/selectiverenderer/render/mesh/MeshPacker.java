package org.selectiverenderer.render.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Packs a mesh into bytes for the graphics card: orders triangles by cluster, numbers vertices in
 * the order of their first use, leaves out unused vertices, and writes attributes compactly.
 * Stateless; safe for use by several threads.
 */
public final class MeshPacker {
  /**
   * Triangles per cluster. A terrain of 784,000 triangles around the viewer took 27 ms of the
   * render thread per frame as a whole, 17 ms in clusters of 128, 512 or 2,048 (llvmpipe, 4 cores);
   * smaller ones draw fewer triangles in more pieces.
   */
  static final int CLUSTER_TRIANGLES = 512;

  /** The number of vertices that two-byte indices can address. */
  static final int SHORT_INDEX_VERTICES = 1 << 16;

  private MeshPacker() {}

  public static PackedMesh pack(Mesh mesh) {
    return pack(RefinedMesh.of(mesh));
  }

  /** Packs all refinement levels of a mesh into one pair of buffers, the finest level first. */
  public static PackedMesh pack(RefinedMesh staged) {
    Mesh mesh = staged.mesh();
    Ordered last = order(mesh, mesh.indices());
    int[] indices = last.indices();
    List<RefinementLevelRange> coarser = List.of();
    int[] numbers = new int[mesh.vertexCount()];
    int[] used;
    if (staged.coarser().isEmpty()) {
      used = firstUse(indices, numbers);
    } else {
      coarser = new ArrayList<>();
      for (RefinedMesh.Stage stage : staged.coarser()) {
        Ordered before = order(mesh, stage.indices());
        coarser.add(
            new RefinementLevelRange(before.clusters().from(indices.length), stage.undivided()));
        indices = joined(indices, before.indices());
      }
      // The vertices of a level stand together: those of the coarsest level come first.
      used = firstUse(joined(staged.coarser().get(0).indices(), indices), numbers);
    }
    VertexLayout layout = VertexLayout.of(mesh);
    boolean wide = used.length > SHORT_INDEX_VERTICES;
    return new PackedMesh(
        mesh.primitive(),
        mesh.solid(),
        layout,
        vertices(mesh, layout, used),
        indices(indices, numbers, wide),
        wide,
        indices.length,
        last.clusters(),
        coarser);
  }

  /** Triangle indices sorted by cluster. */
  private record Ordered(int[] indices, TriangleClusters clusters) {}

  private static Ordered order(Mesh mesh, int[] indices) {
    if (mesh.primitive() != Mesh.Primitive.TRIANGLES) {
      return new Ordered(indices, TriangleClusters.whole(indices.length));
    }
    TriangleClusterer.Result order =
        TriangleClusterer.of(mesh.positions(), indices, CLUSTER_TRIANGLES);
    int[] ordered = reorder(indices, order.triangles());
    return new Ordered(ordered, new ClusterBounds(mesh.positions(), ordered).of(order.ends()));
  }

  private static int[] joined(int[] a, int[] b) {
    int[] both = Arrays.copyOf(a, a.length + b.length);
    System.arraycopy(b, 0, both, a.length, b.length);
    return both;
  }

  private static int[] reorder(int[] indices, int[] triangles) {
    int[] ordered = new int[triangles.length * 3];
    for (int t = 0; t < triangles.length; t++) {
      System.arraycopy(indices, 3 * triangles[t], ordered, 3 * t, 3);
    }
    return ordered;
  }

  /**
   * Numbers the vertices in the order of their first use.
   *
   * @param numbers out: the new number of each vertex, -1 for unused ones
   * @return the old number of each new one
   */
  private static int[] firstUse(int[] indices, int[] numbers) {
    Arrays.fill(numbers, -1);
    int[] used = new int[Math.min(numbers.length, indices.length)];
    int count = 0;
    for (int index : indices) {
      if (numbers[index] < 0) {
        numbers[index] = count;
        used[count++] = index;
      }
    }
    return Arrays.copyOf(used, count);
  }

  private static ByteBuffer vertices(Mesh mesh, VertexLayout layout, int[] used) {
    ByteBuffer out = direct((long) used.length * layout.stride());
    // Written as one array of four-byte words: writing a buffer value by value is several times
    // slower.
    int[] words = new int[used.length * layout.stride() / 4];
    float[] positions = mesh.positions();
    float[] normals = mesh.normals();
    float[] colors = mesh.colors();
    float[] texCoords = mesh.texCoords();
    boolean little = out.order() == ByteOrder.LITTLE_ENDIAN;
    int at = 0;
    for (int vertex : used) {
      words[at++] = Float.floatToRawIntBits(positions[3 * vertex]);
      words[at++] = Float.floatToRawIntBits(positions[3 * vertex + 1]);
      words[at++] = Float.floatToRawIntBits(positions[3 * vertex + 2]);
      if (normals != null) {
        int x = normalised(normals[3 * vertex]);
        int y = normalised(normals[3 * vertex + 1]);
        int z = normalised(normals[3 * vertex + 2]);
        words[at++] = little ? y << 16 | x : x << 16 | y;
        words[at++] = little ? z : z << 16;
      }
      if (colors != null) {
        int rgba = 0;
        for (int channel = 0; channel < 4; channel++) {
          int value = Math.round(clamp(colors[4 * vertex + channel], 0) * 255);
          rgba |= value << 8 * (little ? channel : 3 - channel);
        }
        words[at++] = rgba;
      }
      if (texCoords != null) {
        words[at++] = Float.floatToRawIntBits(texCoords[2 * vertex]);
        words[at++] = Float.floatToRawIntBits(texCoords[2 * vertex + 1]);
      }
      for (Mesh.TexCoords more : mesh.moreTexCoords()) {
        for (int i = 0; i < more.components(); i++) {
          words[at++] = Float.floatToRawIntBits(more.values()[more.components() * vertex + i]);
        }
      }
    }
    out.asIntBuffer().put(words);
    return out;
  }

  /** Returns a signed normalised 16-bit integer in the lower half of an int. */
  private static int normalised(float value) {
    return Math.round(clamp(value, -1) * 32767) & 0xffff;
  }

  private static float clamp(float value, float least) {
    return Math.max(least, Math.min(1, value));
  }

  private static ByteBuffer indices(int[] indices, int[] numbers, boolean wide) {
    ByteBuffer out = direct((long) indices.length * (wide ? 4 : 2));
    if (wide) {
      int[] numbered = new int[indices.length];
      for (int i = 0; i < indices.length; i++) {
        numbered[i] = numbers[indices[i]];
      }
      out.asIntBuffer().put(numbered);
    } else {
      short[] numbered = new short[indices.length];
      for (int i = 0; i < indices.length; i++) {
        numbered[i] = (short) numbers[indices[i]];
      }
      out.asShortBuffer().put(numbered);
    }
    return out;
  }

  private static ByteBuffer direct(long bytes) {
    return ByteBuffer.allocateDirect(Math.toIntExact(bytes)).order(ByteOrder.nativeOrder());
  }

  /** Returns whether a vertex colour is not opaque. */
  public static boolean translucent(Mesh mesh) {
    float[] colors = mesh.colors();
    for (int i = 3; colors != null && i < colors.length; i += 4) {
      if (Math.round(clamp(colors[i], 0) * 255) < 255) {
        return true;
      }
    }
    return false;
  }
}
