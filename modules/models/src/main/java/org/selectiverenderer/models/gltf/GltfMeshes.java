package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes glTF's meshes as Groups of Shapes. A mesh of several nodes is written once and used by its
 * name, except where an animation changes its shape at a node.
 */
final class GltfMeshes {
  private final GltfFile file;
  private final GltfAccessors accessors;
  private final GltfMaterials materials;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final Map<Integer, String> written = new HashMap<>();

  GltfMeshes(
      GltfFile file,
      GltfAccessors accessors,
      X3dWriter out,
      DefNames names,
      GltfProblems problems) {
    this.file = file;
    this.accessors = accessors;
    this.out = out;
    this.names = names;
    this.problems = problems;
    materials = new GltfMaterials(file, out, names, problems);
  }

  /**
   * Points whose places an animation of weights changes.
   *
   * @param coordinate the DEF name of the Coordinate node
   * @param points x, y, z without any target
   * @param targets what a weight of 1 adds, for each target
   */
  record Morph(String coordinate, float[] points, List<float[]> targets) {}

  /**
   * Writes the mesh of a node.
   *
   * @param weights those of the node's morph targets; null for the mesh's
   * @param morphs receives the points of each primitive that has targets; null if no animation
   *     changes them
   */
  void write(int index, double @Nullable [] weights, @Nullable List<Morph> morphs) {
    JsonNode mesh = file.part("meshes", index);
    boolean shared = weights == null && morphs == null;
    String known = shared ? written.get(index) : null;
    if (known != null) {
      out.empty("Group", "USE", known);
      return;
    }
    String def = names.unique(mesh.path("name").asText(""), "mesh" + index);
    if (shared) {
      written.put(index, def);
    }
    double[] given = weights == null ? all(mesh.path("weights")) : weights;
    out.open("Group", "DEF", def);
    int i = 0;
    for (JsonNode primitive : mesh.path("primitives")) {
      String path = "meshes[%d].primitives[%d]".formatted(index, i++);
      primitive(primitive, path, given, morphs);
    }
    out.close();
  }

  /** Returns all numbers of an array. */
  static double[] all(JsonNode array) {
    double[] numbers = new double[array.size()];
    Arrays.setAll(numbers, i -> array.path(i).asDouble(0));
    return numbers;
  }

  private void primitive(
      JsonNode primitive, String path, double[] weights, @Nullable List<Morph> morphs) {
    if (primitive.path("extensions").has("KHR_draco_mesh_compression")) {
      if (!primitive.path("attributes").has("POSITION")
          || !file.part("accessors", GltfFile.index(primitive.path("attributes"), "POSITION"))
              .has("bufferView")) {
        problems.tell(
            path,
            "it is compressed by KHR_draco_mesh_compression, which is not read; it is left out "
                + "(gltf-transform copies a model without that compression)");
        return;
      }
    }
    try {
      Primitive read = read(primitive, path);
      if (read.points().length > 0) {
        shape(read, path, weights, morphs);
      }
    } catch (IOException e) {
      problems.tell(path, e.getMessage() + "; it is left out");
    }
  }

  /** The arrays of a primitive. */
  private record Primitive(
      JsonNode json, int mode, int material, float[] points, int[] indices, int vertices) {}

  private Primitive read(JsonNode primitive, String path) throws IOException {
    int mode = primitive.path("mode").asInt(PrimitiveIndices.TRIANGLES);
    if (mode < PrimitiveIndices.POINTS || mode > PrimitiveIndices.TRIANGLE_FAN) {
      throw new IOException("its mode is none of glTF's");
    }
    int position = GltfFile.index(primitive.path("attributes"), "POSITION");
    if (position < 0 || accessors.components(position) != 3) {
      throw new IOException("it has no positions in three dimensions");
    }
    float[] points = accessors.floats(position);
    int vertices = points.length / 3;
    int index = GltfFile.index(primitive, "indices");
    int[] indices = index < 0 ? PrimitiveIndices.sequence(vertices) : accessors.ints(index);
    for (int i : indices) {
      if (i < 0 || i >= vertices) {
        throw new IOException(
            "its indices name vertex %d, but it has %d; the file is damaged"
                .formatted(i, vertices));
      }
    }
    return new Primitive(
        primitive, mode, GltfFile.index(primitive, "material"), points, indices, vertices);
  }

  private void shape(Primitive from, String path, double[] weights, @Nullable List<Morph> morphs)
      throws IOException {
    List<float[]> targets = targets(from, "POSITION", path);
    float[] points = moved(from.points(), targets, weights);
    String coordinate = "";
    if (morphs != null && !targets.isEmpty()) {
      coordinate = names.unique("", "coordinate");
      morphs.add(new Morph(coordinate, from.points(), targets));
    }
    boolean faces = from.mode() >= PrimitiveIndices.TRIANGLES;
    out.open("Shape");
    materials.write(from.material(), faces);
    if (faces) {
      boolean twoSided = materials.material(from.material()).path("doubleSided").asBoolean(false);
      int normal = attribute(from, "NORMAL", 3);
      out.open("IndexedTriangleSet");
      if (twoSided) {
        out.attribute("solid", "false");
      }
      if (normal < 0) {
        out.attribute("normalPerVertex", "false");
      }
      int[] triangles = PrimitiveIndices.triangles(from.mode(), from.indices());
      out.ownLine().numbers("index", Numbers.list(triangles));
      coordinate(points, coordinate);
      normals(from, normal, weights, path);
      texCoords(from, path);
    } else if (from.mode() == PrimitiveIndices.POINTS) {
      out.open("PointSet");
      coordinate(from.json().has("indices") ? picked(points, from.indices(), 3) : points, "");
    } else {
      out.open("IndexedLineSet");
      int[] lines = PrimitiveIndices.lines(from.mode(), from.indices());
      out.ownLine().numbers("coordIndex", Numbers.list(lines));
      coordinate(points, coordinate);
    }
    colors(from);
    out.close().close();
    tellAttributes(from.json(), path);
  }

  private void coordinate(float[] points, String def) {
    out.open("Coordinate").def(def).ownLine().numbers("point", Numbers.list(points)).close();
  }

  private void normals(Primitive from, int normal, double[] weights, String path)
      throws IOException {
    if (normal >= 0) {
      List<float[]> targets = targets(from, "NORMAL", path);
      float[] vectors = moved(accessors.floats(normal), targets, weights);
      out.open("Normal").ownLine().numbers("vector", Numbers.list(vectors)).close();
    }
  }

  /** Returns what each morph target adds to an attribute; empty if it has none. */
  private List<float[]> targets(Primitive from, String attribute, String path) throws IOException {
    List<float[]> targets = new ArrayList<>();
    boolean any = false;
    for (JsonNode target : from.json().path("targets")) {
      int index = GltfFile.index(target, attribute);
      boolean fits =
          index >= 0
              && accessors.components(index) == 3
              && file.part("accessors", index).path("count").asLong() == from.vertices();
      if (index >= 0 && !fits) {
        problems.tell(path + ".targets", "a target has another number of vertices; it is left out");
      }
      targets.add(fits ? accessors.floats(index) : new float[0]);
      any |= fits;
    }
    return any ? targets : List.of();
  }

  /** Returns points with their targets added by weight. */
  static float[] moved(float[] points, List<float[]> targets, double[] weights) {
    float[] moved = points.clone();
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

  private void texCoords(Primitive from, String path) throws IOException {
    List<TextureChannel> channels = materials.channels(from.material());
    if (GltfMaterials.plain(channels)) {
      int set = attribute(from, "TEXCOORD_0", 2);
      if (set >= 0 && !channels.isEmpty()) {
        texCoord(accessors.floats(set), "");
      }
      return;
    }
    out.open("MultiTextureCoordinate");
    for (int i = 0; i < channels.size(); i++) {
      int set = attribute(from, "TEXCOORD_" + channels.get(i).set(), 2);
      if (set < 0) {
        problems.tell(
            path,
            "its material needs TEXCOORD_%d, which it lacks".formatted(channels.get(i).set()));
      }
      float[] given = set < 0 ? new float[2 * from.vertices()] : accessors.floats(set);
      texCoord(given, GltfMaterials.mappingName(i));
    }
    out.close();
  }

  private void texCoord(float[] uv, String mapping) {
    for (int i = 1; i < uv.length; i += 2) {
      uv[i] = 1 - uv[i]; // glTF's v goes down, X3D's t goes up
    }
    out.open("TextureCoordinate");
    if (!mapping.isEmpty()) {
      out.attribute("mapping", mapping);
      out.attribute("containerField", "texCoord");
    }
    out.ownLine().numbers("point", Numbers.list(uv)).close();
  }

  /** Writes vertex colours, which glTF multiplies by the material's and X3D takes instead of it. */
  private void colors(Primitive from) throws IOException {
    int index = GltfFile.index(from.json().path("attributes"), "COLOR_0");
    int components = index < 0 ? 0 : accessors.components(index);
    boolean counted =
        index >= 0 && file.part("accessors", index).path("count").asLong() == from.vertices();
    if (!counted || components < 3 || components > 4) {
      return;
    }
    float[] colors = accessors.floats(index);
    double[] base = materials.baseColor(from.material());
    boolean faces = from.mode() >= PrimitiveIndices.TRIANGLES;
    boolean unlit =
        !faces || materials.material(from.material()).path("extensions").has("KHR_materials_unlit");
    int size = components == 4 || base[3] < 1 ? 4 : 3;
    float[] mixed = new float[from.vertices() * size];
    for (int v = 0; v < from.vertices(); v++) {
      double[] color = {1, 1, 1, 1};
      for (int k = 0; k < 4; k++) {
        double own = k < components ? colors[v * components + k] : 1;
        color[k] = Numbers.unit(own * base[k]);
      }
      double[] shown = unlit ? GltfMaterials.srgb(color) : color;
      for (int k = 0; k < size; k++) {
        mixed[v * size + k] = (float) (k < 3 ? shown[k] : color[3]);
      }
    }
    if (from.mode() == PrimitiveIndices.POINTS && from.json().has("indices")) {
      mixed = picked(mixed, from.indices(), size);
    }
    out.open(size == 4 ? "ColorRGBA" : "Color");
    out.ownLine().numbers("color", Numbers.list(mixed)).close();
  }

  private static float[] picked(float[] values, int[] indices, int size) {
    float[] picked = new float[Math.multiplyExact(indices.length, size)];
    for (int i = 0; i < indices.length; i++) {
      System.arraycopy(values, indices[i] * size, picked, i * size, size);
    }
    return picked;
  }

  /** Returns an attribute's accessor if it has a value for each vertex; else -1. */
  private int attribute(Primitive from, String name, int components) {
    int index = GltfFile.index(from.json().path("attributes"), name);
    boolean fits =
        index >= 0
            && accessors.components(index) == components
            && file.part("accessors", index).path("count").asLong() == from.vertices();
    return fits ? index : -1;
  }

  private void tellAttributes(JsonNode primitive, String path) {
    JsonNode attributes = primitive.path("attributes");
    if (attributes.has("COLOR_1")) {
      problems.tell(path, "X3D has one colour for each vertex; COLOR_1 is left out");
    }
  }
}
