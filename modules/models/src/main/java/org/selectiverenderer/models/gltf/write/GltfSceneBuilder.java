package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Writes the nodes of a scene, and of what it inlines, as the nodes of a glTF document. Of nodes
 * that select one of their children it writes the child that a browser shows initially.
 */
final class GltfSceneBuilder {
  private static final int DEEPEST = 500;

  private static final Set<String> TRANSFORMS =
      Set.of("Transform", "CADPart", "EspduTransform", "HAnimHumanoid", "HAnimJoint", "HAnimSite");

  private final GltfDocument out = new GltfDocument();
  private final GltfLosses losses;
  private final GltfMetadata metadata;
  private final GltfMeshWriter meshes;
  private final GltfAnimationWriter animations;
  private final GltfInlineReader inlines;
  private final GltfViewWriter views = new GltfViewWriter(out);
  private final ObjectNode scene = out.object();

  GltfSceneBuilder(
      X3dReader reader, UrlResolver root, PngTranscoder transcoder, GltfLosses losses) {
    this.losses = losses;
    metadata = new GltfMetadata(out, losses);
    GltfTextureWriter textures = new GltfTextureWriter(out, root, transcoder, losses);
    meshes =
        new GltfMeshWriter(out, new GltfMaterialWriter(out, textures, losses, metadata), losses);
    animations = new GltfAnimationWriter(out, losses);
    inlines = new GltfInlineReader(reader, root, losses, animations);
  }

  /**
   * Returns the document of a scene.
   *
   * @throws IOException if it exceeds a limit, with a clause that says which
   */
  GltfDocument build(X3dFile file, GltfPlace place) throws IOException {
    animations.find(file);
    List<Integer> roots = new ArrayList<>();
    double unit = unit(file);
    GltfPlace outermost = new GltfPlace(place.file(), place.key(), place.base(), 0, unit);
    for (NodeView node : file.nodes()) {
      visit(node, outermost, roots);
    }
    file.loose().forEach(losses::node);
    if (unit != 1 && !roots.isEmpty()) {
      ObjectNode scaled = out.object().put("name", "unit of length");
      GltfDocument.numbers(scaled, "scale", unit, unit, unit);
      append(scaled, roots);
      roots = List.of(out.add("nodes", scaled));
    }
    animations.write();
    if (!roots.isEmpty()) {
      ArrayNode list = scene.putArray("nodes");
      roots.forEach(list::add);
    }
    out.add("scenes", scene);
    out.root().put("scene", 0);
    return out;
  }

  private void visit(NodeView node, GltfPlace place, List<Integer> siblings) throws IOException {
    out.countNode();
    if (place.depth() > DEEPEST) {
      losses.tell(
          "depth",
          node.location(),
          "nodes are nested more than %d deep; what is inside is left out".formatted(DEEPEST));
      return;
    }
    if (node.type().field("visible").isPresent() && !node.bool("visible")) {
      losses.tell(
          "visible",
          node.location(),
          "glTF has no invisible nodes; %s and all others with visible FALSE are left out"
              .formatted(node.type().name()));
      return;
    }
    switch (node.type().name()) {
      case "Inline" -> inline(node, place, siblings);
      case "WorldInfo" -> worldInfo(node);
      default -> {
        if (node.type().is("X3DShapeNode")) {
          shape(node, place, siblings);
        } else if (GltfViewWriter.isView(node)) {
          if (!node.bool("viewAll")) { // a model without a camera is shown whole everywhere
            siblings.add(add(node, views.view(node)));
          }
        } else if (GltfViewWriter.isLight(node)) {
          light(node, place, siblings);
        } else if (GroupingNodeChildren.isGroup(node.type())
            || node.type().name().equals("LayerSet")) {
          group(node, place, siblings);
        } else if (!animations.takes(node)) {
          losses.node(node);
        }
      }
    }
  }

  private void light(NodeView light, GltfPlace place, List<Integer> siblings) throws IOException {
    if (light.bool("on")) {
      siblings.add(add(light, views.light(light, place.scale())));
    } else {
      losses.tell("light", light.location(), "glTF has no lights that are off; they are left out");
    }
  }

  private void group(NodeView node, GltfPlace place, List<Integer> siblings) throws IOException {
    GltfTransform nodes = transform(node);
    siblings.add(nodes.outer());
    describe(node, out.get("nodes", nodes.outer()));
    List<Integer> children = new ArrayList<>();
    double scale =
        GroupingNodeChildren.placement(node).map(NodeTransform::averageScale).orElse(1.0);
    for (NodeView child : shown(node)) {
      visit(child, place.inside(scale), children);
    }
    append(out.get("nodes", nodes.inner()), children);
  }

  private GltfTransform transform(NodeView node) {
    if (TRANSFORMS.contains(node.type().name())) {
      boolean moves = animations.moves(node);
      GltfTransform nodes = GltfTransform.of(node, moves, out);
      if (moves) {
        animations.place(node, nodes);
      }
      return nodes;
    }
    return GltfTransform.of(GroupingNodeChildren.placement(node).orElseGet(Matrix4d::new), out);
  }

  /** Returns the children that are shown, and reports what shows others at times. */
  private List<? extends NodeView> shown(NodeView node) {
    List<? extends NodeView> children = GroupingNodeChildren.of(node);
    String type = node.type().name();
    switch (type) {
      case "Switch" -> {
        int choice = node.integer("whichChoice");
        if (children.size() > (choice >= 0 && choice < children.size() ? 1 : 0)) {
          losses.tell(
              type,
              node.location(),
              "glTF has no Switch; its choice %d is written, and the others of this one and all"
                      .formatted(choice)
                  + " others are left out");
        }
        return choice >= 0 && choice < children.size() ? List.of(children.get(choice)) : List.of();
      }
      case "LOD" -> {
        if (children.size() > 1) {
          losses.tell(type, node.location(), "glTF has no LOD; the finest level is written");
        }
        return children.stream().limit(1).toList();
      }
      case "Billboard", "Anchor", "Viewport", "ScreenGroup" ->
          losses.tell(type, node.location(), "glTF has no %s; it becomes a group".formatted(type));
      default -> {
        // shows all its children
      }
    }
    return children;
  }

  private void shape(NodeView shape, GltfPlace place, List<Integer> siblings) throws IOException {
    Optional<GltfMeshWriter.Written> mesh = meshes.mesh(shape, place);
    if (mesh.isEmpty()) {
      return;
    }
    ObjectNode node = out.object().put("mesh", mesh.get().index());
    Vector3d at = mesh.get().origin().orElse(new Vector3d());
    if (at.lengthSquared() > 0) {
      GltfDocument.numbers(node, "translation", at.x, at.y, at.z);
    }
    siblings.add(add(shape, node));
  }

  private int add(NodeView from, ObjectNode node) throws IOException {
    describe(from, node);
    return out.add("nodes", node);
  }

  /** Adds what a node has besides its content: its name, its metadata, a Switch its choice. */
  private void describe(NodeView from, ObjectNode to) throws IOException {
    if (from.name() != null) {
      out.countValue(from.name());
      to.put("name", from.name());
    }
    metadata.append(from, to);
    if (from.type().name().equals("Switch")) {
      GltfMetadata.extras(from, to).put("whichChoice", from.integer("whichChoice"));
    }
  }

  private void worldInfo(NodeView info) throws IOException {
    metadata.append(info, scene);
    ObjectNode extras = GltfMetadata.extras(info, scene);
    if (!info.string("title").isEmpty()) {
      scene.put("name", info.string("title"));
      extras.put("title", info.string("title"));
    }
    ArrayNode lines = extras.putArray("info");
    for (String line : info.strings("info")) {
      lines.add(line);
    }
  }

  private void inline(NodeView inline, GltfPlace place, List<Integer> siblings) throws IOException {
    Optional<GltfPlace> inside = inlines.enter(inline, place);
    if (inside.isEmpty()) {
      return;
    }
    X3dFile file = inside.get().file();
    ObjectNode group = out.object();
    double scale = unit(file) / unit(place.file());
    if (scale != 1) {
      GltfDocument.numbers(group, "scale", scale, scale, scale);
    }
    siblings.add(add(inline, group));
    List<Integer> children = new ArrayList<>();
    for (NodeView node : file.nodes()) {
      visit(node, inside.get(), children);
    }
    append(group, children);
    inlines.leave(inside.get());
  }

  private static void append(ObjectNode parent, List<Integer> children) {
    if (!children.isEmpty()) {
      ArrayNode list = parent.putArray("children");
      children.forEach(list::add);
    }
  }

  /** Returns a file's unit of length in metres. */
  private static double unit(X3dFile file) {
    double unit = file.unitLength();
    return unit > 0 && Double.isFinite(unit) ? unit : 1;
  }
}
