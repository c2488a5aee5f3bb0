package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.selectiverenderer.polygon.model.Model;
import org.selectiverenderer.polygon.model.ModelReader;
import org.selectiverenderer.polygon.model.ModelWriter;
import org.selectiverenderer.polygon.model.Urls;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.simplify.ModelSize;
import org.selectiverenderer.polygon.simplify.Simplified;
import org.selectiverenderer.polygon.simplify.Simplifier;
import org.selectiverenderer.polygon.versions.VersionPlan.PlannedFile;
import org.selectiverenderer.x3d.ContentRoot;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.SceneElement;

/** Works out what versions of one object in one scene come to. For one use. */
final class Planning {
  private final ModelWriter writer = new ModelWriter();
  private final Simplifier simplifier = new Simplifier();
  private final VersionMaker.Request request;
  private final SceneSource scene;
  private final ObjectSite site;
  private final ModelReader models;
  private final Problems problems;
  private final Path sceneFolder;
  private final Path outputFolder;

  Planning(
      VersionMaker.Request request,
      SceneSource scene,
      ObjectSite site,
      ModelReader models,
      Problems problems) {
    this.request = request;
    this.scene = scene;
    this.site = site;
    this.models = models;
    this.problems = problems;
    this.sceneFolder = folder(request.scene());
    this.outputFolder = folder(request.output());
  }

  Optional<VersionPlan> plan() throws IOException {
    List<SceneElement> elements = elements();
    if (!new TiesCheck(scene.text().root(), problems).free(request.object(), tied())) {
      return Optional.empty();
    }
    List<NodeView> nodes = elements.stream().map(scene::node).toList();
    Location location = elements.get(0).location();
    Optional<Model> model =
        models.of(
            nodes,
            scene.file(),
            sceneFolder,
            location,
            "the object '" + request.object() + "'",
            problems);
    if (model.isEmpty()) {
      return Optional.empty();
    }
    ModelSize size = ModelSize.of(model.get().meshes());
    List<Goal> goals = goals(size);
    for (Goal goal : goals) {
      if (beyond(goal, size)) {
        problems.error(
            location,
            "the object '%s' has %d polygons and %d vertices, fewer than asked for"
                .formatted(request.object(), size.polygons(), size.vertices()));
        return Optional.empty();
      }
    }
    List<Path> files = files(goals.size() + 1);
    if (!reachable(files)) {
      return Optional.empty();
    }
    return Optional.of(plan(nodes, model.get(), size, goals, files));
  }

  /** The elements that hold the original. */
  private List<SceneElement> elements() {
    if (site instanceof ObjectSite.Whole whole) {
      return whole.elements();
    }
    return ((ObjectSite.Versioned) site).inlines().subList(0, 1);
  }

  /** What moves to another file, and must not be known elsewhere. */
  private List<SceneElement> tied() {
    return site instanceof ObjectSite.Whole whole ? whole.elements() : List.of();
  }

  private List<Goal> goals(ModelSize size) {
    List<Goal> goals = request.goals();
    boolean all =
        goals.size() > 1
            && (goals.get(0).equals(new Goal.VertexPercent(100))
                || goals.get(0).equals(new Goal.Polygons(size.polygons())));
    return all ? goals.subList(1, goals.size()) : goals;
  }

  private boolean beyond(Goal goal, ModelSize size) {
    return goal instanceof Goal.Polygons polygons && polygons.count() > size.polygons()
        || goal instanceof Goal.Vertices vertices && vertices.count() > size.vertices();
  }

  private List<Path> files(int count) {
    String base;
    Path start;
    if (site instanceof ObjectSite.Versioned versioned) {
      NodeView first = scene.node(versioned.inlines().get(0));
      String url = first == null ? "" : first.strings("url")[0];
      base = url.substring(0, url.lastIndexOf("_v"));
      start = outputFolder;
    } else {
      base = fileName(site.name());
      start = outputFolder.resolve(request.inlineFolder());
    }
    return IntStream.rangeClosed(1, count)
        .mapToObj(number -> start.resolve(base + "_v" + number + ".x3d").normalize())
        .toList();
  }

  /** Whether a browser will find the files: scenes name files of their own folders only. */
  private boolean reachable(List<Path> files) {
    Path folder = folder(files.get(0));
    Path above = outputFolder.getParent();
    boolean inside =
        folder.startsWith(outputFolder)
            || above != null && folder.startsWith(above.resolve(ContentRoot.INLINE_FOLDER));
    if (!inside) {
      problems.error(
          Location.of(request.output().toString()),
          "the folder %s is outside the scene's folder, from where a scene inlines nothing"
              .formatted(folder));
    }
    return inside;
  }

  private VersionPlan plan(
      List<NodeView> nodes, Model model, ModelSize size, List<Goal> goals, List<Path> files)
      throws IOException {
    Simplified[] reduced = new Simplified[goals.size()];
    IntStream.range(0, reduced.length)
        .parallel()
        .forEach(i -> reduced[i] = simplifier.simplify(model.meshes(), goals.get(i)));
    List<Version> versions = new ArrayList<>();
    List<PlannedFile> planned = new ArrayList<>();
    versions.add(new Version(1, files.get(0), size.vertices(), size.polygons(), 0, true));
    if (site instanceof ObjectSite.Whole) {
      planned.add(planned(files.get(0), original(nodes, files.get(0), size)));
    }
    for (int i = 0; i < reduced.length; i++) {
      Path file = files.get(i + 1);
      Simplified result = reduced[i];
      versions.add(
          new Version(
              i + 2, file, result.vertices(), result.polygons(), result.error(), result.met()));
      planned.add(planned(file, text(model.with(result.parts()), file, i + 2, result)));
    }
    TextEdits edits = new TextEdits(scene.text());
    edit(edits, files);
    planned.add(planned(request.output(), scene.bytes(edits.changed())));
    return new VersionPlan(
        request.object(), versions, planned, request.output(), edits.edits(scene.file().source()));
  }

  private byte[] original(List<NodeView> nodes, Path file, ModelSize size) {
    return writer
        .text(
            nodes,
            scene.file(),
            sceneFolder,
            folder(file),
            String.valueOf(file.getFileName()),
            "%s, version 1: %d polygons, as modelled".formatted(site.name(), size.polygons()))
        .getBytes(StandardCharsets.UTF_8);
  }

  private byte[] text(Model model, Path file, int number, Simplified result) {
    return writer
        .text(
            model,
            folder(file),
            String.valueOf(file.getFileName()),
            "%s, version %d: reduced to %d polygons"
                .formatted(site.name(), number, result.polygons()))
        .getBytes(StandardCharsets.UTF_8);
  }

  private void edit(TextEdits edits, List<Path> files) {
    List<String> urls = files.stream().map(file -> Urls.between(outputFolder, file)).toList();
    if (site instanceof ObjectSite.Whole whole) {
      SceneElement first = whole.elements().get(0);
      List<String> names = new ArrayList<>();
      for (int i = 1; i <= files.size(); i++) {
        names.add(free("Inline_" + site.name() + "_v" + i));
      }
      edits.replace(
          first,
          SwitchText.lines(
              free("Switch_" + site.name()), names, urls, edits.quote(), edits.step(first)));
      whole.elements().stream().skip(1).forEach(edits::remove);
      return;
    }
    List<SceneElement> inlines = ((ObjectSite.Versioned) site).inlines();
    int had = inlines.size();
    SceneElement last = inlines.get(had - 1);
    if (files.size() > had) {
      edits.insertAfter(
          last,
          IntStream.rangeClosed(had + 1, files.size())
              .mapToObj(number -> SwitchText.further(edits, last, had, number))
              .toList());
    }
    inlines.stream().skip(files.size()).forEach(edits::remove);
  }

  /** A name that no node has. */
  private String free(String name) {
    Set<String> taken = new HashSet<>();
    scene.text().root().visit(element -> element.attribute("DEF").ifPresent(taken::add));
    String free = name;
    for (int i = 2; taken.contains(free); i++) {
      free = name + "_" + i;
    }
    return free;
  }

  private static PlannedFile planned(Path file, byte[] content) throws IOException {
    if (!Files.isRegularFile(file)) {
      return new PlannedFile(file, content, PlannedFile.State.NEW);
    }
    boolean same = Arrays.equals(Files.readAllBytes(file), content);
    return new PlannedFile(
        file, content, same ? PlannedFile.State.UNCHANGED : PlannedFile.State.CHANGED);
  }

  /** A name that every file system takes. */
  private static String fileName(String name) {
    StringBuilder safe = new StringBuilder();
    name.codePoints()
        .forEach(
            c ->
                safe.appendCodePoint(
                    Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.' ? c : '_'));
    return safe.toString();
  }

  private static Path folder(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    Path parent = absolute.getParent();
    return parent == null ? absolute : parent;
  }
}
