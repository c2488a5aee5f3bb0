package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;

/**
 * The arrays of a primitive, the part of a glTF mesh that is drawn at once.
 *
 * @param path its path in the model, for messages
 * @param mode the drawing mode of {@link PrimitiveIndices}
 * @param points x, y, z of each vertex
 * @param indices its vertices in the order in which they are drawn
 */
record GltfPrimitive(
    GltfFile file,
    GltfAccessors accessors,
    JsonNode json,
    String path,
    int mode,
    float[] points,
    int[] indices) {

  /**
   * Reads the positions and indices of a primitive.
   *
   * @throws IOException if they are damaged or missing, with one sentence
   */
  static GltfPrimitive of(
      GltfFile file, GltfAccessors accessors, JsonNode json, String path, GltfProblems problems)
      throws IOException {
    int mode = json.path("mode").asInt(PrimitiveIndices.TRIANGLES);
    if (mode < PrimitiveIndices.POINTS || mode > PrimitiveIndices.TRIANGLE_FAN) {
      throw new IOException("its mode is none of glTF's");
    }
    int position = GltfFile.index(json.path("attributes"), "POSITION");
    if (position < 0 || accessors.components(position) != 3) {
      throw new IOException("it has no positions in three dimensions");
    }
    float[] points = accessors.floats(position);
    int vertices = points.length / 3;
    int index = GltfFile.index(json, "indices");
    if (accessors.isUnpacked(index)) {
      mode = PrimitiveIndices.TRIANGLES; // Draco has strips as triangles, too
    }
    int[] indices = index < 0 ? PrimitiveIndices.sequence(vertices) : accessors.ints(index);
    OptionalInt outside = Arrays.stream(indices).filter(i -> i < 0 || i >= vertices).findFirst();
    if (outside.isPresent()) {
      String damage =
          "its indices name vertex %d, but it has %d; the file is damaged"
              .formatted(outside.getAsInt(), vertices);
      indices = inside(PrimitiveIndices.triangles(mode, indices), vertices);
      if (mode < PrimitiveIndices.TRIANGLES || indices.length == 0) {
        throw new IOException(damage);
      }
      problems.tell(path, damage + ", and the triangles there are left out");
      mode = PrimitiveIndices.TRIANGLES;
    }
    return new GltfPrimitive(file, accessors, json, path, mode, points, indices);
  }

  /** Returns the triangles of three vertices that exist. */
  private static int[] inside(int[] triangles, int vertices) {
    int[] kept = new int[triangles.length];
    int count = 0;
    for (int i = 0; i < triangles.length; i += 3) {
      boolean exist = Arrays.stream(triangles, i, i + 3).allMatch(v -> v >= 0 && v < vertices);
      if (exist && Arrays.stream(triangles, i, i + 3).distinct().count() == 3) {
        System.arraycopy(triangles, i, kept, count, 3);
        count += 3;
      }
    }
    return Arrays.copyOf(kept, count);
  }

  int vertices() {
    return points.length / 3;
  }

  int material() {
    return GltfFile.index(json, "material");
  }

  /** Returns whether it consists of triangles, not of lines or points. */
  boolean faces() {
    return mode >= PrimitiveIndices.TRIANGLES;
  }

  /** Returns the accessor of an attribute; -1 if there is none with a value for each vertex. */
  int attribute(String name, int components) {
    return fitting(GltfFile.index(json.path("attributes"), name), components);
  }

  private int fitting(int accessor, int components) {
    boolean fits =
        accessor >= 0
            && accessors.components(accessor) == components
            && file.part("accessors", accessor).path("count").asLong() == vertices();
    return fits ? accessor : -1;
  }

  /** Returns the normals; none if it has none. */
  float[] normals() throws IOException {
    int normal = attribute("NORMAL", 3);
    return normal < 0 ? new float[0] : accessors.floats(normal);
  }

  /** Returns what each morph target adds to an attribute; empty if none adds anything. */
  List<float[]> targets(String attribute, GltfProblems problems) throws IOException {
    List<float[]> targets = new ArrayList<>();
    boolean any = false;
    for (JsonNode target : json.path("targets")) {
      int index = GltfFile.index(target, attribute);
      boolean fits = fitting(index, 3) >= 0;
      if (index >= 0 && !fits) {
        problems.tell(path + ".targets", "a target has another number of vertices; it is left out");
      }
      targets.add(fits ? accessors.floats(index) : new float[0]);
      any |= fits;
    }
    return any ? targets : List.of();
  }

  /** Returns values with their targets added by weight. */
  static float[] moved(float[] values, List<float[]> targets, double[] weights) {
    float[] moved = values.clone();
    for (int t = 0; t < Math.min(targets.size(), weights.length); t++) {
      float[] target = targets.get(t);
      double weight = weights[t];
      if (weight != 0 && Double.isFinite(weight) && target.length == moved.length) {
        for (int i = 0; i < moved.length; i++) {
          moved[i] += (float) (weight * target[i]);
        }
      }
    }
    return moved;
  }

  /** Returns normals with their targets added by weight, of length 1 again. */
  static float[] turned(float[] normals, List<float[]> targets, double[] weights) {
    if (targets.isEmpty()) {
      return normals;
    }
    float[] turned = moved(normals, targets, weights);
    for (int i = 0; i + 2 < turned.length; i += 3) {
      double length =
          Math.sqrt(
              (double) turned[i] * turned[i]
                  + (double) turned[i + 1] * turned[i + 1]
                  + (double) turned[i + 2] * turned[i + 2]);
      for (int k = i; k < i + 3 && length > 0; k++) {
        turned[k] = (float) (turned[k] / length);
      }
    }
    return turned;
  }
}
