package org.selectiverenderer.models;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedBone;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;
import org.selectiverenderer.models.importer.ImportedModel.ImportedNode;
import org.selectiverenderer.models.scene.AnimatedNodes;
import org.selectiverenderer.models.scene.AnimationWriter;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.HumanoidWriter;
import org.selectiverenderer.models.scene.ModelNode;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.models.scene.Skin;
import org.selectiverenderer.models.scene.XmlText;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes what Assimp has read as a scene: a Transform for each node, by its name. For one use. */
final class ImportedSceneWriter {

  /** The elements that a node at the deepest level may have inside, and those around the nodes. */
  private static final int OTHER_DEPTH = 12;

  private final ImportedModel model;
  private final ModelSource file;
  private final ProblemCollector problems;
  private final ImportedModelConverter meshes;
  private final ImportedMaterials materials;
  private final ImportedViewWriter views;
  private final HumanoidWriter figures;
  private final X3dWriter out;
  private final DefNames names = new DefNames();
  private final AnimatedNodes animated = new AnimatedNodes();
  private final List<List<Integer>> children = new ArrayList<>();
  private final List<ModelNode> nodes = new ArrayList<>();
  private final Map<Integer, Integer> uses = new HashMap<>();
  private final Map<Integer, String> written = new HashMap<>();
  private final Set<Integer> skinned = new LinkedHashSet<>();
  private final int maxDepth;
  private int decimals;

  /**
   * @param limits the limits of the text
   */
  ImportedSceneWriter(
      ImportedModel model,
      ModelSource file,
      NodeCatalogue catalogue,
      ReadLimits limits,
      ProblemCollector problems) {
    this.model = model;
    this.file = file;
    this.problems = problems;
    out = new X3dWriter(1 << 16, limits.maxBytes());
    maxDepth = Math.max(1, limits.maxDepth() - OTHER_DEPTH);
    meshes = new ImportedModelConverter(file, catalogue, problems);
    materials = new ImportedMaterials(model, file, catalogue, out, names, problems);
    views = new ImportedViewWriter(model, out, names, file, problems);
    figures = new HumanoidWriter(out, names, animated);
    for (ImportedNode node : model.nodes()) {
      double[] matrix = new double[16];
      for (int i = 0; i < 16; i++) {
        matrix[i] = Float.isFinite(node.matrix()[i]) ? node.matrix()[i] : i % 5 == 0 ? 1 : 0;
      }
      nodes.add(new ModelNode(node.parent(), node.name(), NodeTransform.of(matrix)));
      children.add(new ArrayList<>());
      if (node.parent() >= 0) {
        children.get(node.parent()).add(nodes.size() - 1);
      }
      for (int mesh : node.meshes()) {
        uses.merge(mesh, 1, Integer::sum);
      }
    }
  }

  /**
   * Returns the text.
   *
   * @throws IOException if it would be longer than the limits allow, with one sentence
   */
  String text(String title, String description) throws IOException {
    try {
      return scene(title, description);
    } catch (UncheckedIOException e) { // the text becomes too long
      throw new IOException(e.getCause().getMessage(), e);
    }
  }

  private String scene(String title, String description) {
    boolean figure = model.meshes().stream().anyMatch(mesh -> !mesh.bones().isEmpty());
    // since X3D 4.0 a picture multiplies the diffuse colour, as in the formats that are imported
    out.file(figure ? "Full" : "Immersive", "4.0").open("head");
    out.meta("title", title).meta("description", description);
    out.meta("generator", "Selective Renderer").close().open("Scene");
    List<Mesh> all = new ArrayList<>();
    for (ImportedMesh mesh : model.meshes()) {
      all.add(meshes.mesh(mesh, materials.isTextured(mesh.material())));
    }
    decimals = ModelWriter.decimals(all.stream().filter(mesh -> !mesh.isEmpty()).toList());
    if (!nodes.isEmpty()) {
      node(0, 0, all);
    }
    skinned.forEach(this::figure);
    new ImportedAnimationWriter(model, new AnimationWriter(out, names, animated), file, problems)
        .write();
    return out.finish();
  }

  private void node(int index, int depth, List<Mesh> all) {
    ModelNode node = nodes.get(index);
    if (depth > maxDepth) {
      problems.warning(
          SourceLocation.of(file.name()),
          "nodes are nested too deep; those below %s are left out".formatted(shown(node.name())));
      return;
    }
    boolean plainRoot = index == 0 && isPlain(node.place()) && !isAnimated(0);
    if (!plainRoot) {
      String def = names.unique(node.name(), "node" + index);
      animated.add(index, def);
      out.open("Transform", "DEF", def);
      node.place().write(out);
      if (node.place().sheared()) {
        problems.warning(
            SourceLocation.of(file.name()),
            "node %s shears, which a Transform cannot; the shear is left out"
                .formatted(shown(node.name())));
      }
      if (!node.name().isBlank() && !node.name().equals(def)) {
        String name = XmlText.of(node.name()).replace("\\", "\\\\").replace("\"", "\\\"");
        out.empty("MetadataString", "name", "name", "value", '"' + name + '"');
      }
    }
    views.write(index);
    for (int mesh : model.nodes().get(index).meshes()) {
      mesh(mesh, all.get(mesh));
    }
    children.get(index).forEach(child -> node(child, depth + 1, all));
    if (!plainRoot) {
      out.close();
    }
  }

  /** Returns a name of the model for a problem: in quotes, and cut where it is long. */
  static String shown(String name) {
    return "'" + name.substring(0, Math.min(60, name.length())) + "'";
  }

  private boolean isAnimated(int node) {
    return model.animations().stream()
        .flatMap(animation -> animation.channels().stream())
        .anyMatch(channel -> channel.node() == node);
  }

  private static boolean isPlain(NodeTransform place) {
    double[] t = place.translation();
    double[] s = place.scale();
    return t[0] == 0
        && t[1] == 0
        && t[2] == 0
        && Numbers.axisAngle(place.rotation())[3] == 0
        && s[0] == 1
        && s[1] == 1
        && s[2] == 1;
  }

  private void mesh(int index, Mesh mesh) {
    ImportedMesh from = model.meshes().get(index);
    boolean points = ImportedPointWriter.isPoints(from);
    if (mesh.isEmpty() && !points) {
      return;
    }
    if (!points && !from.bones().isEmpty()) {
      skinned.add(index);
      return;
    }
    String known = written.get(index);
    if (known != null) {
      out.empty("Shape", "USE", known);
      return;
    }
    String def = names.unique(from.name(), "mesh" + index);
    written.put(index, def);
    out.open("Shape", "DEF", def);
    if (points) {
      new ImportedPointWriter(model, out).write(from);
    } else {
      materials.write(from.material());
      new MeshWriter(out, mesh, decimals).append();
    }
    out.close();
  }

  private void figure(int index) {
    ImportedMesh mesh = model.meshes().get(index);
    List<ImportedBone> bones = mesh.bones();
    List<double[]> inverses = new ArrayList<>();
    List<HumanoidWriter.Weight> weights = new ArrayList<>();
    for (int i = 0; i < bones.size(); i++) {
      double[] inverse = new double[16];
      for (int k = 0; k < 16; k++) {
        inverse[k] = bones.get(i).inverse()[k];
      }
      inverses.add(inverse);
      for (int k = 0; k < bones.get(i).vertices().length; k++) {
        float weight = bones.get(i).weights()[k];
        if (weight > 0 && Float.isFinite(weight)) {
          weights.add(new HumanoidWriter.Weight(bones.get(i).vertices()[k], i, weight));
        }
      }
    }
    int[] joints = bones.stream().mapToInt(ImportedBone::node).toArray();
    Skin skin = new Skin(nodes, joints, inverses);
    if (skin.isDeeperThan(maxDepth)) {
      problems.warning(
          SourceLocation.of(file.name()),
          "the joints of mesh %s are nested too deep; it is left out"
              .formatted(shown(mesh.name())));
      return;
    }
    if (!skin.isExact()) {
      problems.warning(
          SourceLocation.of(file.name()),
          "mesh %s was bound to a joint with a matrix that shears, mirrors or scales differently along its axes, which an HAnimJoint cannot; it may look distorted"
              .formatted(shown(mesh.name())));
    }
    float[] normals = mesh.normals() == null ? new float[0] : mesh.normals();
    boolean usable = ImportedModelConverter.units(normals);
    HumanoidWriter.Surface surface =
        new HumanoidWriter.Surface(
            ImportedModelConverter.clean(mesh.positions()),
            usable ? normals : new float[0],
            weights);
    try {
      figures.write(
          skin, mesh.name(), surface, (coordinate, normal) -> skinShape(mesh, coordinate, normal));
    } catch (IOException e) {
      problems.warning(
          SourceLocation.of(file.name()),
          "%s; mesh %s is left out".formatted(e.getMessage(), shown(mesh.name())));
    }
  }

  private void skinShape(ImportedMesh mesh, String coordinate, String normal) {
    out.open("Shape", "containerField", "skin");
    materials.write(mesh.material());
    out.open("IndexedTriangleSet");
    if (normal.isEmpty()) {
      out.attribute("normalPerVertex", "false");
    }
    out.ownLine().numbers("index", Numbers.list(meshes.finite(mesh)));
    out.empty("Coordinate", "USE", coordinate);
    if (!normal.isEmpty()) {
      out.empty("Normal", "USE", normal);
    }
    if (mesh.texCoords() != null && materials.isTextured(mesh.material())) {
      out.open("TextureCoordinate").ownLine();
      out.numbers("point", Numbers.list(ImportedModelConverter.clean(mesh.texCoords()))).close();
    }
    out.close().close();
  }
}
