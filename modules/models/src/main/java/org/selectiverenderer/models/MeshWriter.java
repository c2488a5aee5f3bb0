package org.selectiverenderer.models;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.write.IndexedFaceSetWriter;
import org.selectiverenderer.x3d.write.TupleListBuilder;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes a mesh as an IndexedFaceSet. Each distinct point, normal, colour and texture coordinate is
 * written once, so that the number of points is the number of vertices that modelling programs
 * report.
 */
final class MeshWriter {
  private static final int NORMAL_DECIMALS = 3;
  private static final int COLOR_DECIMALS = 3;
  private static final int TEXTURE_DECIMALS = 5;
  private static final int PER_LINE = 16;

  /** Distinct tuples in order of first use, and which of them each corner takes. */
  private record Stream(TupleListBuilder values, int[] ids) {}

  private final X3dWriter out;
  private final Mesh mesh;
  private final int decimals;

  MeshWriter(X3dWriter out, Mesh mesh, int decimals) {
    this.out = out;
    this.mesh = mesh;
    this.decimals = decimals;
  }

  void append() {
    boolean translucent = translucent();
    Stream points = stream(mesh.positions(), 3, decimals);
    Stream normals =
        mesh.normals() == null || flat() ? null : stream(mesh.normals(), 3, NORMAL_DECIMALS);
    Stream colors =
        mesh.colors() == null
            ? null
            : stream(translucent ? mesh.colors() : opaque(), translucent ? 4 : 3, COLOR_DECIMALS);
    Stream texCoords =
        mesh.texCoords() == null ? null : stream(mesh.texCoords(), 2, TEXTURE_DECIMALS);
    IndexedFaceSetWriter set = new IndexedFaceSetWriter(out, 0, mesh.solid());
    index(set, "coordIndex", points);
    index(set, "normalIndex", normals);
    index(set, "colorIndex", colors);
    index(set, "texCoordIndex", texCoords);
    values(set, "Coordinate", "point", points);
    values(set, "Normal", "vector", normals);
    values(set, translucent ? "ColorRGBA" : "Color", "color", colors);
    values(set, "TextureCoordinate", "point", texCoords);
    set.close();
  }

  /**
   * Returns whether every corner has the normal of its triangle, which is the default of a browser.
   */
  private boolean flat() {
    float[] n = mesh.normals();
    if (n == null) {
      return false;
    }
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      double[] face = FaceNormal.of(mesh.positions(), indices, i);
      for (int corner = i; corner < i + 3; corner++) {
        int at = 3 * indices[corner];
        if (n[at] * face[0] + n[at + 1] * face[1] + n[at + 2] * face[2] < 0.9999) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean translucent() {
    float[] colors = mesh.colors();
    for (int i = 3; colors != null && i < colors.length; i += 4) {
      if (colors[i] < 1) {
        return true;
      }
    }
    return false;
  }

  private float[] opaque() {
    float[] rgba = mesh.colors() == null ? new float[0] : mesh.colors();
    float[] rgb = new float[rgba.length / 4 * 3];
    for (int i = 0, j = 0; i < rgba.length; i += 4, j += 3) {
      System.arraycopy(rgba, i, rgb, j, 3);
    }
    return rgb;
  }

  private Stream stream(float[] values, int size, int places) {
    Map<String, Integer> known = new HashMap<>();
    int[] idOfVertex = new int[mesh.vertexCount()];
    Arrays.fill(idOfVertex, -1);
    int[] ids = new int[mesh.indices().length];
    TupleListBuilder all = TupleListBuilder.perLine(PER_LINE);
    StringBuilder tuple = new StringBuilder();
    for (int i = 0; i < ids.length; i++) {
      int vertex = mesh.indices()[i];
      if (idOfVertex[vertex] < 0) {
        tuple.setLength(0);
        for (int k = 0; k < size; k++) {
          DecimalFormatter.appendRounded(tuple, values[size * vertex + k], places);
          tuple.append(k < size - 1 ? " " : "");
        }
        int next = known.size();
        Integer id = known.putIfAbsent(tuple.toString(), next);
        if (id == null) {
          all.next().append(tuple);
        }
        idOfVertex[vertex] = id == null ? next : id;
      }
      ids[i] = idOfVertex[vertex];
    }
    return new Stream(all, ids);
  }

  private static void index(IndexedFaceSetWriter set, String field, @Nullable Stream stream) {
    if (stream != null) {
      set.index(field, TupleListBuilder.perLine(PER_LINE).triangles(stream.ids()));
    }
  }

  private static void values(
      IndexedFaceSetWriter set, String node, String field, @Nullable Stream stream) {
    if (stream != null) {
      set.values(node, field, stream.values());
    }
  }

  /** Computes the normal of a triangle. */
  static final class FaceNormal {
    private FaceNormal() {}

    /**
     * Returns the unit normal; NaN for a triangle without area.
     *
     * @param at position of the triangle's first corner in the indices
     */
    static double[] of(float[] positions, int[] indices, int at) {
      int a = 3 * indices[at];
      int b = 3 * indices[at + 1];
      int c = 3 * indices[at + 2];
      double[] normal = new double[3];
      TriangleMath.normal(positions, a, b, c, normal);
      double length = TriangleMath.length(normal);
      return new double[] {normal[0] / length, normal[1] / length, normal[2] / length};
    }
  }
}
