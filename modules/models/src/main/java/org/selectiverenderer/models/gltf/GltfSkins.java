package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.models.scene.AnimatedNodes;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.HumanoidWriter;
import org.selectiverenderer.models.scene.ModelNode;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.models.scene.Skin;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes meshes with skins as HAnimHumanoids, each primitive with those joints that move it. The
 * nodes themselves stay Transforms, which hold what hangs on a joint.
 */
final class GltfSkins {
  private final GltfFile file;
  private final GltfAccessors accessors;
  private final GltfShapes shapes;
  private final GltfProblems problems;
  private final HumanoidWriter figures;
  private final Map<Integer, Optional<Skin>> skins = new HashMap<>();
  private final List<ModelNode> nodes = new ArrayList<>();

  GltfSkins(
      GltfFile file,
      GltfAccessors accessors,
      GltfShapes shapes,
      X3dWriter out,
      DefNames names,
      AnimatedNodes animated,
      GltfProblems problems) {
    this.file = file;
    this.accessors = accessors;
    this.shapes = shapes;
    this.problems = problems;
    figures = new HumanoidWriter(out, names, animated);
  }

  /**
   * Returns whether a skin can be written; if not, why has been told.
   *
   * @param maxDepth how deep joints may be nested
   */
  boolean has(int index, int maxDepth) {
    Optional<Skin> skin =
        skins.computeIfAbsent(
            index,
            unused -> {
              try {
                return Optional.of(read(index, maxDepth));
              } catch (IOException e) {
                problems.tell(
                    "skins[%d]".formatted(index),
                    e.getMessage() + "; the mesh is shown as it is without its skeleton");
                return Optional.empty();
              }
            });
    return skin.isPresent();
  }

  private Skin read(int index, int maxDepth) throws IOException {
    JsonNode skin = file.part("skins", index);
    int count = skin.path("joints").size();
    if (count == 0) {
      throw new IOException("there is no such skin, or it has no joints");
    }
    readNodes();
    int[] joints = new int[count];
    for (int i = 0; i < count; i++) {
      joints[i] = skin.path("joints").path(i).asInt(-1);
      if (joints[i] < 0 || joints[i] >= nodes.size()) {
        throw new IOException("a joint is none of the nodes");
      }
    }
    int inverse = GltfFile.index(skin, "inverseBindMatrices");
    float[] matrices = inverse < 0 ? new float[0] : accessors.floats(inverse);
    if (inverse >= 0 && matrices.length < 16L * count) {
      throw new IOException("it has fewer inverseBindMatrices than joints");
    }
    List<double[]> inverses = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double[] matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      for (int k = 0; k < 16 && inverse >= 0; k++) {
        matrix[k] = matrices[16 * i + k];
      }
      inverses.add(matrix);
    }
    Skin read = new Skin(nodes, joints, inverses);
    if (read.isDeeperThan(maxDepth)) {
      throw new IOException("its joints are nested too deep");
    }
    if (!read.isExact()) {
      problems.tell(
          "skins[%d]".formatted(index),
          "a joint was bound with a matrix that shears, mirrors or scales differently along its "
              + "axes, which an HAnimJoint cannot; the skin may look distorted");
    }
    return read;
  }

  private void readNodes() {
    JsonNode all = file.root().path("nodes");
    if (!nodes.isEmpty()) {
      return;
    }
    int[] parents = new int[all.size()];
    Arrays.fill(parents, -1);
    for (int i = 0; i < parents.length; i++) {
      for (JsonNode child : all.path(i).path("children")) {
        int below = child.asInt(-1);
        if (below >= 0 && below < parents.length) {
          parents[below] = i; // the structure check has found that they are a tree
        }
      }
    }
    for (int i = 0; i < parents.length; i++) {
      JsonNode node = all.path(i);
      NodeTransform place = GltfFile.transform(node);
      nodes.add(new ModelNode(parents[i], GltfFile.text(node, "name"), place));
    }
  }

  /**
   * Writes a primitive of a skin that can be written.
   *
   * @param name the name of the mesh, or ""
   * @param points its points, with its morph targets
   * @param normals likewise; empty for none
   */
  void write(int index, String name, GltfPrimitive primitive, float[] points, float[] normals)
      throws IOException {
    Skin skin = skins.getOrDefault(index, Optional.empty()).orElseThrow();
    List<HumanoidWriter.Weight> weights = weights(skin, primitive);
    GltfShapes.Skinned shape = shapes.skinned(primitive);
    figures.write(skin, name, new HumanoidWriter.Surface(points, normals, weights), shape::write);
  }

  private List<HumanoidWriter.Weight> weights(Skin skin, GltfPrimitive primitive)
      throws IOException {
    List<HumanoidWriter.Weight> weights = new ArrayList<>();
    for (int set = 0; primitive.json().path("attributes").has("JOINTS_" + set); set++) {
      int jointsOf = primitive.attribute("JOINTS_" + set, 4);
      int weightsOf = primitive.attribute("WEIGHTS_" + set, 4);
      if (jointsOf < 0 || weightsOf < 0) {
        throw new IOException(
            "JOINTS_%d and WEIGHTS_%d differ from its vertices".formatted(set, set));
      }
      int[] joints = accessors.ints(jointsOf);
      float[] given = accessors.floats(weightsOf);
      for (int i = 0; i < joints.length; i++) {
        if (!(given[i] > 0)) {
          continue;
        }
        if (joints[i] < 0 || joints[i] >= skin.size()) {
          throw new IOException(
              "its JOINTS_%d name joint %d, but its skin has %d; the file is damaged"
                  .formatted(set, joints[i], skin.size()));
        }
        weights.add(new HumanoidWriter.Weight(i / 4, joints[i], given[i]));
      }
    }
    return weights;
  }
}
