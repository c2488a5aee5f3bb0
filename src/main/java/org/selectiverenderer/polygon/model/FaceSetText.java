package org.selectiverenderer.polygon.model;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * A mesh as an IndexedFaceSet: each point, normal, colour and texture coordinate once, so that its
 * Coordinate has as many points as its author counts vertices.
 */
final class FaceSetText {
  private static final int NORMAL_DECIMALS = 3;
  private static final int COLOR_DECIMALS = 3;
  private static final int TEXTURE_DECIMALS = 5;
  private static final int PER_LINE = 16;

  /** Distinct tuples in order of first use, and which of them each corner takes. */
  private record Stream(StringBuilder values, int[] ids) {}

  private final StringBuilder text;
  private final Mesh mesh;
  private final int decimals;

  FaceSetText(StringBuilder text, Mesh mesh, int decimals) {
    this.text = text;
    this.mesh = mesh;
    this.decimals = decimals;
  }

  void append() {
    Stream points = stream(mesh.positions(), 3, decimals);
    text.append("      <IndexedFaceSet");
    if (!mesh.solid()) {
      text.append(" solid='false'");
    }
    boolean flat = flat();
    boolean translucent = translucent();
    Stream normals =
        mesh.normals() == null || flat ? null : stream(mesh.normals(), 3, NORMAL_DECIMALS);
    Stream colors =
        mesh.colors() == null
            ? null
            : stream(translucent ? mesh.colors() : opaque(), translucent ? 4 : 3, COLOR_DECIMALS);
    Stream texCoords =
        mesh.texCoords() == null ? null : stream(mesh.texCoords(), 2, TEXTURE_DECIMALS);
    index("coordIndex", points);
    index("normalIndex", normals);
    index("colorIndex", colors);
    index("texCoordIndex", texCoords);
    text.append(">\n");
    values("Coordinate point", points);
    values("Normal vector", normals);
    values(translucent ? "ColorRGBA color" : "Color color", colors);
    values("TextureCoordinate point", texCoords);
    text.append("      </IndexedFaceSet>\n");
  }

  /** Whether every corner has the normal of its triangle, which is what a browser takes itself. */
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
    StringBuilder all = new StringBuilder(24 * mesh.vertexCount());
    StringBuilder tuple = new StringBuilder();
    for (int i = 0; i < ids.length; i++) {
      int vertex = mesh.indices()[i];
      if (idOfVertex[vertex] < 0) {
        tuple.setLength(0);
        for (int k = 0; k < size; k++) {
          NumberText.append(tuple, values[size * vertex + k], places);
          tuple.append(k < size - 1 ? " " : "");
        }
        int next = known.size();
        Integer id = known.putIfAbsent(tuple.toString(), next);
        if (id == null) {
          all.append(next == 0 ? "" : next % PER_LINE == 0 ? "\n" : " ").append(tuple);
        }
        idOfVertex[vertex] = id == null ? next : id;
      }
      ids[i] = idOfVertex[vertex];
    }
    return new Stream(all, ids);
  }

  private void index(String name, @Nullable Stream stream) {
    if (stream == null) {
      return;
    }
    text.append("\n          ").append(name).append("='");
    int[] ids = stream.ids();
    for (int i = 0; i < ids.length; i += 3) {
      text.append(i == 0 ? "" : i / 3 % PER_LINE == 0 ? "\n" : " ");
      text.append(ids[i]).append(' ').append(ids[i + 1]).append(' ').append(ids[i + 2]);
      text.append(" -1");
    }
    text.append('\'');
  }

  private void values(String element, @Nullable Stream stream) {
    if (stream != null) {
      text.append("        <").append(element).append("='").append(stream.values());
      text.append("'/>\n");
    }
  }
}
