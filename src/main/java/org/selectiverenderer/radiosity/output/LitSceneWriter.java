package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.selectiverenderer.polygon.model.NumberText;
import org.selectiverenderer.polygon.model.Urls;
import org.selectiverenderer.polygon.model.ValueText;
import org.selectiverenderer.radiosity.bake.LitScene;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.nodes.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Route;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * Writes a lit scene. Groups, sensors, metadata, names and routes stay; a shape or Inline that is
 * USEd in several places has a copy in each, and only the first keeps the names, since light
 * differs from place to place. The same scene gives the same bytes.
 */
public final class LitSceneWriter {
  private final LitScene lit;
  private final LitFiles files;
  private final Problems problems;
  private final Map<ShapeInstance, Integer> bodies = new IdentityHashMap<>();

  /**
   * @param file of the scene
   * @param folder for what it inlines
   * @param problems hears what could not be kept
   */
  public LitSceneWriter(LitScene lit, Path file, Path folder, Problems problems) {
    this.lit = lit;
    this.files = new LitFiles(file, folder);
    this.problems = problems;
    for (int i = 0; i < lit.scene().bodies().size(); i++) {
      bodies.put(lit.scene().bodies().get(i).shape(), i);
    }
  }

  /** The texts by file, the scene's own among them. */
  public Map<Path, String> write(Scene scene, InstanceTree tree, String description) {
    file(files.scene(), scene, tree.root(), description);
    return files.texts();
  }

  private void file(Path file, Scene scene, GroupInstance root, String description) {
    StringBuilder text = new StringBuilder();
    head(text, file, scene, description);
    Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent());
    NodeText nodes = new NodeText(text, folder);
    for (Instance child : root.children()) {
      write(child, nodes, text, folder, "", 4);
    }
    int left = 0;
    for (Route route : scene.routes()) {
      left += route(route, nodes, text) ? 0 : 1;
    }
    if (left > 0 || !scene.imported().isEmpty()) {
      problems.info(
          Location.of(scene.url()),
          "routes and IMPORTs that lead to nodes without a name of their own are not in the lit scene");
    }
    scene
        .exports()
        .forEach(
            (as, name) ->
                text.append("    <EXPORT localDEF='")
                    .append(ValueText.escape(name))
                    .append("' AS='")
                    .append(ValueText.escape(as))
                    .append("'/>\n"));
    files.put(file, text.append("  </Scene>\n</X3D>\n").toString());
  }

  private static boolean route(Route route, NodeText nodes, StringBuilder text) {
    String from = nodes.name(route.from());
    String to = nodes.name(route.to());
    if (from.isEmpty() || to.isEmpty()) {
      return false;
    }
    text.append("    <ROUTE");
    nodes.attribute("fromNode", from);
    nodes.attribute("fromField", route.from().type().fields().get(route.fromField()).name());
    nodes.attribute("toNode", to);
    nodes.attribute("toField", route.to().type().fields().get(route.toField()).name());
    text.append("/>\n");
    return true;
  }

  private static void head(StringBuilder text, Path file, Scene scene, String description) {
    String profile = scene.profile().isEmpty() ? "Immersive" : scene.profile();
    String version = scene.version().isEmpty() ? "3.3" : scene.version();
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile='")
        .append(ValueText.escape(profile))
        .append("' version='")
        .append(ValueText.escape(version))
        .append("'>\n  <head>\n");
    scene
        .components()
        .forEach(
            (name, level) ->
                text.append("    <component name='")
                    .append(ValueText.escape(name))
                    .append("' level='")
                    .append(level.intValue())
                    .append("'/>\n"));
    if (scene.unitLength() != 1) {
      text.append("    <unit category='length' name='length' conversionFactor='")
          .append(NumberText.shortest(scene.unitLength()))
          .append("'/>\n");
    }
    meta(text, "title", String.valueOf(file.getFileName()));
    meta(text, "description", description);
    meta(text, "generator", "./selective-renderer radiosity");
    String licence = scene.meta().get("license");
    if (licence != null) {
      meta(text, "license", licence);
    }
    text.append("  </head>\n  <Scene>\n");
  }

  private static void meta(StringBuilder text, String name, String content) {
    text.append("    <meta name='").append(name).append("' content='");
    text.append(ValueText.escape(content)).append("'/>\n");
  }

  private void write(
      Instance instance,
      NodeText nodes,
      StringBuilder text,
      Path folder,
      String container,
      int indent) {
    Node node = instance.node();
    if (instance instanceof ShapeInstance shape && bodies.containsKey(shape)) {
      String def = ShapeText.def(nodes.define(node));
      new ShapeText(lit).append(text, bodies.get(shape), def, indent);
    } else if (instance instanceof GroupInstance group && !used(group, nodes)) {
      group(group, nodes, text, folder, container, indent);
    } else if (instance instanceof LightInstance && nodes.name(node).isEmpty()) {
      nodes.open(node, ShapeText.def(nodes.define(node)), "", container, indent);
      nodes.attributes(node, "on");
      nodes.attribute("on", "false");
      text.append("/>\n");
    } else {
      nodes.append(node, container, indent);
    }
  }

  /** Whether a group can be USEd as it stands in the file: it holds nothing that is lit. */
  private boolean used(GroupInstance group, NodeText nodes) {
    return !nodes.name(group.node()).isEmpty() && !holdsLit(group);
  }

  private boolean holdsLit(Instance instance) {
    return instance instanceof ShapeInstance shape && bodies.containsKey(shape)
        || instance instanceof GroupInstance group
            && group.children().stream().anyMatch(this::holdsLit);
  }

  private void group(
      GroupInstance group,
      NodeText nodes,
      StringBuilder text,
      Path folder,
      String container,
      int indent) {
    Node node = group.node();
    nodes.open(node, ShapeText.def(nodes.define(node)), "", container, indent);
    boolean filled = node instanceof InlineNode && holdsLit(group);
    if (filled) {
      inline((InlineNode) node, group, nodes, folder);
    } else {
      nodes.attributes(node, "");
    }
    List<Instance> children = node instanceof InlineNode ? List.of() : group.children();
    if (children.isEmpty() && !nodes.hasNodes(node, "children")) {
      text.append("/>\n");
      return;
    }
    text.append(">\n");
    nodes.nodes(node, "children", indent + 2);
    for (Instance child : children) {
      write(child, nodes, text, folder, "children", indent + 2);
    }
    nodes.close(node, indent);
  }

  private void inline(InlineNode inline, GroupInstance group, NodeText nodes, Path folder) {
    Scene content = inline.content().orElseThrow();
    Path file = files.next(inline.strings("url")[0]);
    nodes.attributes(inline, "url");
    nodes.attribute("url", '"' + Urls.between(folder, file) + '"');
    file(
        file,
        content,
        (GroupInstance) group.children().get(0),
        "Lit in its place by radiosity, from " + Path.of(content.url()).getFileName());
  }
}
