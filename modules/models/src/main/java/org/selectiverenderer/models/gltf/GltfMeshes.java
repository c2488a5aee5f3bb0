package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes glTF's meshes as Groups of Shapes. A mesh of several nodes is written once and used by its
 * name, except where an animation changes its shape at a node.
 */
final class GltfMeshes {
  private final GltfFile file;
  private final GltfAccessors accessors;
  private final GltfDraco draco;
  private final GltfShapes shapes;
  private final GltfSkins skins;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final Map<Integer, String> written = new HashMap<>();

  GltfMeshes(
      GltfFile file,
      GltfAccessors accessors,
      GltfDraco draco,
      GltfShapes shapes,
      GltfSkins skins,
      X3dWriter out,
      DefNames names,
      GltfProblems problems) {
    this.file = file;
    this.accessors = accessors;
    this.draco = draco;
    this.shapes = shapes;
    this.skins = skins;
    this.out = out;
    this.names = names;
    this.problems = problems;
  }

  /**
   * Values of a node that an animation of weights changes.
   *
   * @param def the DEF name of the Coordinate or Normal
   * @param values x, y, z without any target
   * @param targets what a weight of 1 adds, for each target
   * @param normals whether they are normals
   */
  record Morph(String def, float[] values, List<float[]> targets, boolean normals) {}

  /**
   * Writes the mesh of a node.
   *
   * @param weights those of the node's morph targets; null for the mesh's
   * @param morphs receives what an animation changes of each primitive that has targets; null if
   *     there is none
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
    double[] given = weights(mesh, weights);
    out.open("Group", "DEF", def);
    each(index, primitive -> shape(primitive, given, morphs));
    out.close();
  }

  /**
   * Writes the mesh of a node with a skin, in the coordinates of the scene.
   *
   * @param weights those of the node's morph targets; null for the mesh's
   * @param maxDepth how deep joints may be nested
   */
  void writeSkinned(int index, int skin, double @Nullable [] weights, int maxDepth) {
    JsonNode mesh = file.part("meshes", index);
    String name = mesh.path("name").asText("");
    double[] given = weights(mesh, weights);
    each(
        index,
        primitive -> {
          if (primitive.faces() && skins.has(skin, maxDepth)) {
            float[] points =
                GltfPrimitive.moved(
                    primitive.points(), primitive.targets("POSITION", problems), given);
            float[] normals =
                GltfPrimitive.turned(
                    primitive.normals(), primitive.targets("NORMAL", problems), given);
            skins.write(skin, name, primitive, points, normals);
          } else {
            shape(primitive, given, null);
          }
        });
  }

  private static double[] weights(JsonNode mesh, double @Nullable [] weights) {
    return weights == null ? all(mesh.path("weights")) : weights;
  }

  /** Returns all numbers of an array. */
  static double[] all(JsonNode array) {
    double[] numbers = new double[array.size()];
    Arrays.setAll(numbers, i -> array.path(i).asDouble(0));
    return numbers;
  }

  /** Writes a primitive that has been read. */
  @FunctionalInterface
  private interface PrimitiveUser {
    void use(GltfPrimitive primitive) throws IOException;
  }

  private void each(int mesh, PrimitiveUser user) {
    int i = 0;
    for (JsonNode primitive : file.part("meshes", mesh).path("primitives")) {
      String path = "meshes[%d].primitives[%d]".formatted(mesh, i++);
      try {
        draco.unpack(primitive);
        GltfPrimitive read = GltfPrimitive.of(file, accessors, primitive, path, problems);
        if (read.vertices() > 0) {
          user.use(read);
        }
      } catch (IOException e) {
        problems.tell(path, e.getMessage() + "; it is left out");
      } finally {
        accessors.forgetUnpacked();
      }
    }
  }

  private void shape(GltfPrimitive from, double[] weights, @Nullable List<Morph> morphs)
      throws IOException {
    List<float[]> targets = from.targets("POSITION", problems);
    float[] normals = from.faces() ? from.normals() : new float[0];
    List<float[]> turning = normals.length == 0 ? List.of() : from.targets("NORMAL", problems);
    String coordinate = "";
    String normal = "";
    if (morphs != null && !targets.isEmpty()) {
      coordinate = names.unique("", "coordinate");
      morphs.add(new Morph(coordinate, from.points(), targets, false));
    }
    if (morphs != null && !turning.isEmpty()) {
      normal = names.unique("", "normal");
      morphs.add(new Morph(normal, normals, turning, true));
    }
    shapes.write(
        from,
        new GltfShapes.Form(
            GltfPrimitive.moved(from.points(), targets, weights),
            coordinate,
            GltfPrimitive.turned(normals, turning, weights),
            normal,
            !targets.isEmpty() || !turning.isEmpty()));
  }
}
