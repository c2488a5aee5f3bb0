package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes a lit scene. Groups, sensors, metadata, DEF names and routes stay; a shape or Inline that
 * is USEd several times is copied for each use, and only the first copy keeps the DEF names, since
 * light differs from place to place. The same scene gives the same bytes.
 */
public final class LitSceneWriter {
  private final LitSceneFormat form;
  private final LitFileSet files;
  private final ProblemCollector problems;
  private final Map<ShapeInstance, Integer> bodies = new IdentityHashMap<>();

  /**
   * @param form the format of lit shapes and lights
   * @param file the file for the lit scene
   * @param folder the folder for the files that it inlines
   * @param problems receives notes on nodes that could not be kept
   */
  public LitSceneWriter(
      RadiosityScene scene,
      LitSceneFormat form,
      Path file,
      Path folder,
      ProblemCollector problems) {
    this.form = form;
    this.files = new LitFileSet(file, folder);
    this.problems = problems;
    for (int i = 0; i < scene.bodies().size(); i++) {
      bodies.put(scene.bodies().get(i).shape(), i);
    }
  }

  /** Returns the X3D texts by file, the scene's own included. */
  public Map<Path, String> write(Scene scene, InstanceTree tree, String description) {
    file(files.scene(), scene, tree.root(), form.places().at(null), description);
    return files.texts();
  }

  private void file(Path file, Scene scene, GroupInstance root, int place, String description) {
    X3dWriter out = new X3dWriter();
    head(out, file, scene, place, description);
    LitFileWriter into = new LitFileWriter(out, file, place, prefix(scene));
    for (Instance child : root.children()) {
      write(child, into, "");
    }
    int left = 0;
    for (Route route : scene.routes()) {
      left += route(route, into) ? 0 : 1;
    }
    if (left > 0 || !scene.imported().isEmpty()) {
      problems.info(
          SourceLocation.of(scene.url()),
          "ROUTEs and IMPORTs of nodes without a DEF name of their own are not in the lit"
              + " scene");
    }
    scene.exports().forEach((as, name) -> out.empty("EXPORT", "localDEF", name, "AS", as));
    files.put(file, out.finish());
  }

  /** Returns a prefix that no DEF name of a scene begins with. */
  private static String prefix(Scene scene) {
    String prefix = "Lit";
    while (startsSome(scene, prefix)) {
      prefix += "_";
    }
    return prefix;
  }

  private static boolean startsSome(Scene scene, String prefix) {
    return scene.named().keySet().stream().anyMatch(name -> name.startsWith(prefix));
  }

  private static boolean route(Route route, LitFileWriter into) {
    String from = into.nodes().name(route.from());
    String to = into.nodes().name(route.to());
    if (from.isEmpty() || to.isEmpty()) {
      return false;
    }
    String fromField = route.from().type().fields().get(route.fromField()).name();
    String toField = route.to().type().fields().get(route.toField()).name();
    into.out().route(from, fromField, to, toField);
    return true;
  }

  private void head(X3dWriter out, Path file, Scene scene, int place, String description) {
    out.file(
        scene.profile().isEmpty() ? "Immersive" : scene.profile(),
        form.version(place, scene.version().isEmpty() ? "3.3" : scene.version()));
    out.open("head");
    scene.components().forEach(out::component);
    if (scene.unitLength() != 1) {
      out.unit("length", "length", scene.unitLength());
    }
    out.meta("title", String.valueOf(file.getFileName())).meta("description", description);
    out.meta("generator", "./selective-renderer radiosity");
    String licence = scene.meta().get("license");
    if (licence != null) {
      out.meta("license", licence);
    }
    out.close().open("Scene");
  }

  private void write(Instance instance, LitFileWriter into, String container) {
    Node node = instance.node();
    X3dNodeWriter nodes = into.nodes();
    if (instance instanceof ShapeInstance shape && bodies.containsKey(shape)) {
      form.shape(into, bodies.get(shape), shape);
    } else if (instance instanceof GroupInstance group && !used(group, nodes)) {
      group(group, into, container);
    } else if (instance instanceof LightInstance light && nodes.name(node).isEmpty()) {
      form.light(into, light, container);
    } else {
      nodes.append(node, container, into);
    }
  }

  /**
   * Returns whether a group can be written as a USE of an earlier one: it is named already and
   * holds no lit shape.
   */
  private boolean used(GroupInstance group, X3dNodeWriter nodes) {
    return !nodes.name(group.node()).isEmpty() && !holdsLit(group);
  }

  private boolean holdsLit(Instance instance) {
    return instance instanceof ShapeInstance shape && bodies.containsKey(shape)
        || instance instanceof GroupInstance group
            && group.children().stream().anyMatch(this::holdsLit);
  }

  private void group(GroupInstance group, LitFileWriter into, String container) {
    Node node = group.node();
    X3dNodeWriter nodes = into.nodes();
    nodes.open(node, container);
    if (node instanceof InlineNode inline && holdsLit(group)) {
      inline(inline, group, into);
    } else {
      nodes.values(node, "", into);
    }
    nodes.nodes(node, "children", into);
    if (!(node instanceof InlineNode)) {
      group.children().forEach(child -> write(child, into, "children"));
    }
    into.out().close();
  }

  private void inline(InlineNode inline, GroupInstance group, LitFileWriter into) {
    Scene content = inline.content().orElseThrow();
    Path file = files.next(inline.strings("url")[0]);
    into.nodes().values(inline, "url", into);
    into.out()
        .attribute("url", FieldValueFormatter.strings(UrlRelativizer.between(into.folder(), file)));
    file(
        file,
        content,
        (GroupInstance) group.children().get(0),
        form.places().at(group),
        "Lit in its place by radiosity, from " + Path.of(content.url()).getFileName());
  }
}
