package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.scene.AnimatedNodes;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Translates one glTF file. Both have metres, y upwards, and cameras that look along -z, so that
 * nothing is turned. For one use.
 */
public final class GltfTranslator {
  /** The elements that a node at the deepest level may have inside, and those around the nodes. */
  private static final int OTHER_DEPTH = 12;

  /**
   * Characters of the text for each value; the text is in memory several times while it is read.
   */
  private static final int CHARACTERS = 16;

  private static final Set<String> KNOWN_EXTENSIONS =
      Set.of(
          "KHR_materials_unlit",
          "KHR_materials_pbrSpecularGlossiness",
          "KHR_materials_emissive_strength",
          "KHR_texture_transform",
          "KHR_lights_punctual",
          "KHR_mesh_quantization",
          "EXT_meshopt_compression",
          "KHR_draco_mesh_compression",
          "EXT_texture_webp");

  private final GltfFile file;
  private final GltfProblems problems;
  private final X3dWriter out;
  private final DefNames names = new DefNames();
  private final GltfAccessors accessors;
  private final GltfMeshes meshes;
  private final GltfViews views;
  private final AnimatedNodes animated = new AnimatedNodes();
  private final List<SkinnedMesh> skinned = new ArrayList<>();
  private final Map<Integer, List<GltfMeshes.Morph>> morphs = new HashMap<>();
  private final Set<Integer> morphing = new HashSet<>();
  private final int maxDepth;

  /** The mesh of a node with a skin, which is shown where its joints are. */
  private record SkinnedMesh(int mesh, int skin, double @Nullable [] weights) {}

  private GltfTranslator(
      GltfFile file,
      GltfAccessors accessors,
      GltfDraco draco,
      ModelFile model,
      ProblemCollector collector) {
    this.file = file;
    problems = new GltfProblems(model.name(), collector);
    out = new X3dWriter(1 << 16, model.limits().maxBytes());
    this.accessors = accessors;
    GltfShapes shapes = new GltfShapes(new GltfTranslation(file, out, names, problems));
    GltfSkins skins = new GltfSkins(file, accessors, shapes, out, names, animated, problems);
    meshes = new GltfMeshes(file, accessors, draco, shapes, skins, out, names, problems);
    views = new GltfViews(file, out, names, problems);
    maxDepth = Math.max(1, model.limits().maxDepth() - OTHER_DEPTH);
  }

  /**
   * Returns the X3D text of a model.
   *
   * @return empty for glTF 1.0, which has other members than 2.0
   * @throws IOException if nothing of it can be read, or the text would be longer than the limits
   *     of the model allow, with one sentence
   */
  public static Optional<String> x3d(ModelFile model, ProblemCollector problems)
      throws IOException {
    GltfFile file;
    try {
      file = GltfFile.of(model);
    } catch (OldGltfException e) {
      return Optional.empty();
    }
    GltfAccessors accessors = new GltfAccessors(file, model.limits().maxBytes() / CHARACTERS);
    try (GltfDraco draco = new GltfDraco(file, accessors)) {
      return Optional.of(new GltfTranslator(file, accessors, draco, model, problems).translate());
    } catch (UncheckedIOException e) { // the text becomes too long
      throw new IOException(e.getCause().getMessage(), e);
    }
  }

  private String translate() throws IOException {
    checkExtensions();
    loadBuffers();
    findMorphs();
    // the draft of X3D 4.1 has the node Tangent
    out.file("Full", hasTangents() ? "4.1" : "4.0").open("head");
    String generator = GltfFile.text(file.root().path("asset"), "generator");
    if (!generator.isBlank()) {
      out.meta("reference", "glTF written by " + generator);
    }
    String copyright = GltfFile.text(file.root().path("asset"), "copyright");
    if (!copyright.isBlank()) {
      out.meta("rights", copyright);
    }
    out.meta("generator", "Selective Renderer").close().open("Scene");
    for (int node : roots()) {
      node(node, 0, 1);
    }
    for (SkinnedMesh mesh : skinned) {
      meshes.writeSkinned(mesh.mesh(), mesh.skin(), mesh.weights(), maxDepth);
    }
    new GltfAnimations(file, accessors, out, names, problems, animated, morphs).write();
    return out.finish();
  }

  private void checkExtensions() {
    JsonNode required = file.root().path("extensionsRequired");
    for (int i = 0; i < required.size(); i++) {
      String name = required.path(i).asText("");
      if (!KNOWN_EXTENSIONS.contains(name)) {
        String shown = name.length() > 60 ? name.substring(0, 60) : name;
        problems.tell(
            "extensionsRequired[%d]".formatted(i),
            "the model needs the extension %s, which is not read; parts may be missing"
                .formatted(shown));
      }
    }
  }

  /** Reads all buffers, since without one nothing is whole. */
  private void loadBuffers() throws IOException {
    for (int i = 0; i < file.root().path("buffers").size(); i++) {
      file.buffer(i);
    }
  }

  private void findMorphs() {
    for (JsonNode animation : file.root().path("animations")) {
      for (JsonNode channel : animation.path("channels")) {
        JsonNode target = channel.path("target");
        if (target.path("path").asText("").equals("weights")) {
          morphing.add(GltfFile.index(target, "node"));
        }
      }
    }
  }

  private boolean hasTangents() {
    for (JsonNode mesh : file.root().path("meshes")) {
      for (JsonNode primitive : mesh.path("primitives")) {
        JsonNode material = file.referred(primitive, "material", "materials");
        if (primitive.path("attributes").has("TANGENT") && material.has("normalTexture")) {
          return true;
        }
      }
    }
    return false;
  }

  private List<Integer> roots() {
    JsonNode scenes = file.root().path("scenes");
    List<Integer> roots = new ArrayList<>();
    if (scenes.size() == 0) {
      Set<Integer> below = new HashSet<>();
      JsonNode nodes = file.root().path("nodes");
      nodes.forEach(node -> node.path("children").forEach(child -> below.add(child.asInt(-1))));
      for (int i = 0; i < nodes.size(); i++) {
        if (!below.contains(i)) {
          roots.add(i);
        }
      }
      return roots;
    }
    int shown = Math.max(0, GltfFile.index(file.root(), "scene"));
    if (scenes.size() > 1) {
      problems.tell(
          "scenes",
          "the model has %d scenes, of which scenes[%d] is read".formatted(scenes.size(), shown));
    }
    scenes.path(shown).path("nodes").forEach(node -> roots.add(node.asInt(-1)));
    return roots;
  }

  /**
   * Writes a node.
   *
   * @param scale by what the nodes around it multiply lengths
   */
  private void node(int index, int depth, double scale) {
    JsonNode node = file.part("nodes", index);
    String path = "nodes[%d]".formatted(index);
    if (node.isMissingNode()) {
      problems.tell(path, "there is no such node; the file is damaged");
      return;
    }
    if (depth > maxDepth) {
      problems.tell(path, "nodes are nested too deep; those below are left out");
      return;
    }
    String name = GltfFile.text(node, "name");
    String def = names.unique(name, "node" + index);
    animated.add(index, def);
    NodeTransform place = GltfFile.transform(node);
    if (place.sheared()) {
      problems.tell(path + ".matrix", "it shears, which a Transform cannot; the shear is left out");
    }
    out.open("Transform", "DEF", def);
    place.write(out);
    if (!name.isBlank() && !name.equals(def)) {
      out.empty("MetadataString", "name", "name", "value", quoted(name));
    }
    double inside = scale * NodeTransform.averageScale(place.matrix());
    views.write(node, path, name, inside);
    int mesh = GltfFile.index(node, "mesh");
    if (mesh >= 0) {
      mesh(node, mesh, index, path);
    }
    node.path("children").forEach(child -> node(child.asInt(-1), depth + 1, inside));
    out.close();
  }

  private void mesh(JsonNode node, int mesh, int index, String path) {
    if (file.part("meshes", mesh).isMissingNode()) {
      problems.tell(path + ".mesh", "there is no meshes[%d]; the file is damaged".formatted(mesh));
      return;
    }
    if (node.path("extensions").has("EXT_mesh_gpu_instancing")) {
      problems.tell(path, "EXT_mesh_gpu_instancing is not read; the mesh is shown once");
    }
    double[] weights = node.has("weights") ? GltfMeshes.all(node.path("weights")) : null;
    if (node.has("skin")) {
      if (morphing.contains(index)) {
        problems.tell(
            path, "its morph targets are animated, which a mesh with a skin is not; they stay");
      }
      skinned.add(new SkinnedMesh(mesh, GltfFile.index(node, "skin"), weights));
    } else if (morphing.contains(index)) {
      List<GltfMeshes.Morph> moved = new ArrayList<>();
      meshes.write(mesh, weights, moved);
      morphs.put(index, moved);
    } else {
      meshes.write(mesh, weights, null);
    }
  }

  /** Returns a text as the only value of an MFString. */
  private static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
