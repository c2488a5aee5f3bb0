package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.ModelWriter;
import org.selectiverenderer.models.simplify.EmptyModelException;
import org.selectiverenderer.models.simplify.ModelSize;
import org.selectiverenderer.models.simplify.SimplificationResult;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.models.simplify.Simplifier;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Plans the versions of one object in one scene, for one use: simplifies the model, names the files
 * and creates the edit.
 */
final class VersionsPlanner {
  private final ModelWriter writer = new ModelWriter();
  private final Simplifier simplifier = new Simplifier();
  private final VersionsEdit.Request request;
  private final ElementNodeMapping scene;
  private final ObjectElements site;
  private final ModelReader models;
  private final X3dReader reader;
  private final ProblemCollector problems;
  private final Path sceneFolder;
  private final Path outputFolder;
  private final VersionFileNames names;
  private final NodeCatalogue catalogue;

  VersionsPlanner(
      VersionsEdit.Request request,
      ElementNodeMapping scene,
      ObjectElements site,
      ModelReader models,
      X3dReader reader,
      NodeCatalogue catalogue,
      ProblemCollector problems) {
    this.catalogue = catalogue;
    this.request = request;
    this.scene = scene;
    this.site = site;
    this.models = models;
    this.reader = reader;
    this.problems = problems;
    this.sceneFolder = VersionFileNames.folder(request.scene());
    this.outputFolder = VersionFileNames.folder(request.output());
    this.names =
        new VersionFileNames(scene, site, outputFolder, request.inlineFolder(), request.name());
  }

  Optional<VersionsEdit> plan() throws IOException {
    List<DocumentElement> elements = elements();
    CrossFileReferences ties = new CrossFileReferences(scene, problems);
    if (!ties.free(request.object(), tied())) {
      return Optional.empty();
    }
    List<NodeView> nodes = elements.stream().map(scene::node).toList();
    SourceLocation location = elements.get(0).location();
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
    List<SimplificationTarget> goals = goals(size);
    List<Integer> missing =
        request.kept().stream().filter(number -> number > own().size()).sorted().toList();
    if (!missing.isEmpty()) {
      problems.error(
          location,
          "version %2$d of the object '%1$s' cannot be kept, because it does not exist"
              .formatted(request.object(), missing.get(0)));
      return Optional.empty();
    }
    for (int i = 0; i < goals.size(); i++) {
      if (!kept(i + 2) && beyond(goals.get(i), size)) {
        problems.error(
            location,
            "the object '%s' has only %s and %s, fewer than asked for"
                .formatted(
                    request.object(),
                    Pluralizer.of(size.polygons(), "polygon"),
                    size.vertices() + (size.vertices() == 1 ? " vertex" : " vertices")));
        return Optional.empty();
      }
    }
    if (!reachable(names.of(1, 1).get(0))
        || site instanceof ObjectElements.Versioned versioned
            && !new VersionRemovalCheck(scene, versioned, problems).possible(goals.size() + 1)) {
      return Optional.empty();
    }
    ties.warnOfLosses(request.object(), tied());
    return plan(nodes, model.get(), size, goals);
  }

  /** Returns the elements of the original. */
  private List<DocumentElement> elements() {
    if (site instanceof ObjectElements.Whole whole) {
      return whole.elements();
    }
    return ((ObjectElements.Versioned) site).inlines().subList(0, 1);
  }

  private List<String> urls(List<Path> files) {
    return files.stream().map(file -> UrlRelativizer.between(outputFolder, file)).toList();
  }

  /** Returns the elements that are moved to another file and must not be referenced elsewhere. */
  private List<DocumentElement> tied() {
    return site instanceof ObjectElements.Whole whole ? whole.elements() : List.of();
  }

  private List<SimplificationTarget> goals(ModelSize size) {
    List<SimplificationTarget> goals = request.goals();
    boolean all =
        request.kept().isEmpty()
            && goals.size() > 1
            && (goals.get(0).equals(new SimplificationTarget.VertexPercent(100))
                || goals.get(0).equals(new SimplificationTarget.Polygons(size.polygons())));
    return all ? goals.subList(1, goals.size()) : goals;
  }

  private boolean beyond(SimplificationTarget goal, ModelSize size) {
    return goal instanceof SimplificationTarget.Polygons polygons
            && polygons.count() > size.polygons()
        || goal instanceof SimplificationTarget.Vertices vertices
            && vertices.count() > size.vertices();
  }

  /** Returns whether browsers may load the files: scenes load only files of their own projects. */
  private boolean reachable(Path file) {
    Path folder = VersionFileNames.folder(file);
    boolean inside = new UrlResolver(outputFolder, request.access()).mayBeNamed(folder);
    if (!inside) {
      problems.error(
          SourceLocation.of(request.output().toString()),
          ("the folder %s is outside the scene's folder, where a scene cannot inline "
                  + "files; name a folder inside")
              .formatted(folder));
    }
    return inside;
  }

  private Optional<VersionsEdit> plan(
      List<NodeView> nodes, Model model, ModelSize size, List<SimplificationTarget> goals)
      throws IOException {
    SimplificationResult[] reduced = new SimplificationResult[goals.size()];
    try {
      IntStream.range(0, reduced.length)
          .parallel()
          .filter(i -> !kept(i + 2))
          .forEach(i -> reduced[i] = simplifier.simplify(model.meshes(), goals.get(i)));
    } catch (EmptyModelException e) {
      problems.error(
          SourceLocation.of(request.scene().toString()),
          "the object '%s' %s; nothing has been changed"
              .formatted(request.object(), e.getMessage()));
      return Optional.empty();
    }
    FileCollisionCheck foreign =
        new FileCollisionCheck(request, site, elsewhere() ? List.of() : own());
    int attempt = 1;
    List<Path> files = names.of(goals.size() + 1, attempt, request.kept());
    List<PlannedFile> planned = planned(files, nodes, model, size, reduced);
    Optional<FileCollisionCheck.Collision> inTheWay = foreign.in(planned);
    if (site instanceof ObjectElements.Versioned
        && !elsewhere()
        && inTheWay.isPresent()
        && inTheWay.get().shownBy().isEmpty()) {
      problems.error(
          SourceLocation.of(inTheWay.get().file().file().toString()),
          ("the file exists already and is not a version of the object '%s'; move it "
                  + "away first; nothing has been changed")
              .formatted(request.object()));
      return Optional.empty();
    }
    Optional<FileCollisionCheck.Collision> first = inTheWay;
    while (inTheWay.isPresent()) {
      files = names.of(goals.size() + 1, ++attempt, request.kept());
      planned = planned(files, nodes, model, size, reduced);
      inTheWay = foreign.in(planned);
    }
    if (first.isPresent()) {
      tellOfNames(first.get(), files);
    }
    List<ObjectVersion> versions = new ArrayList<>();
    versions.add(new ObjectVersion(1, files.get(0), size.vertices(), size.polygons(), 0, true));
    for (int i = 0; i < reduced.length; i++) {
      SimplificationResult result = reduced[i];
      if (result == null) {
        versions.add(there(i + 2, files.get(i + 1)));
        continue;
      }
      versions.add(
          new ObjectVersion(
              i + 2,
              files.get(i + 1),
              result.vertices(),
              result.polygons(),
              result.error(),
              result.met()));
    }
    tellOfOtherFiles(files.size());
    List<String> urls = urls(files);
    List<Path> own = own();
    List<String> renamed = new ArrayList<>();
    for (int i = 0; i < Math.min(files.size(), own.size()); i++) {
      if (!own.get(i).equals(files.get(i))) {
        renamed.add(urls.get(i));
      }
    }
    Edit edit =
        new Edit(
            "Make versions of " + request.object(),
            new VersionSwitchEdit(scene, site, renamed, catalogue).changes(urls));
    PlannedFile changed = planned(request.output(), scene.snapshot().bytes(edit), false);
    return Optional.of(
        new VersionsEdit(scene.snapshot(), request.object(), versions, planned, changed, edit));
  }

  private void tellOfNames(FileCollisionCheck.Collision collision, List<Path> files) {
    int number = site instanceof ObjectElements.Versioned ? 2 : 1;
    problems.info(
        SourceLocation.of(collision.file().file().toString()),
        collision
                .shownBy()
                .map(scene -> "%s shows the file, so it stays as it is".formatted(scene))
                .orElse(
                    "the file exists already and is not a version of '%s'"
                        .formatted(request.object()))
            + "; the versions of '%s' are named %s and so on"
                .formatted(
                    request.object(), files.get(Math.min(number, files.size()) - 1).getFileName()));
  }

  private boolean kept(int number) {
    return request.kept().contains(number);
  }

  /** Returns the files of the object's existing versions; none for an object without versions. */
  private List<Path> own() {
    return site instanceof ObjectElements.Versioned versioned
        ? names.of(versioned.inlines().size(), 1)
        : List.of();
  }

  /** Returns a version that is kept as it is; its deviation from the original is unknown. */
  private ObjectVersion there(int number, Path file) throws IOException {
    Optional<Model> model =
        Files.isReadable(file) ? models.read(file, new ProblemCollector()) : Optional.empty();
    if (model.isEmpty()) {
      problems.warning(
          SourceLocation.of(file.toString()),
          "version %d of the object '%s' cannot be read; it is kept as it is"
              .formatted(number, request.object()));
    }
    ModelSize size = model.map(read -> ModelSize.of(read.meshes())).orElse(new ModelSize(0, 0));
    return new ObjectVersion(number, file, size.vertices(), size.polygons(), Double.NaN, true);
  }

  private List<PlannedFile> planned(
      List<Path> files,
      List<NodeView> nodes,
      Model model,
      ModelSize size,
      SimplificationResult[] reduced)
      throws IOException {
    List<PlannedFile> planned = new ArrayList<>();
    if (site instanceof ObjectElements.Whole) {
      planned.add(planned(files.get(0), original(nodes, files.get(0), size), false));
    } else if (elsewhere()) {
      planned.add(planned(files.get(0), Files.readAllBytes(source()), false));
    }
    for (int i = 0; i < reduced.length; i++) {
      Path file = files.get(i + 1);
      if (reduced[i] != null) {
        byte[] text = text(model.with(reduced[i].parts()), file, i + 2, reduced[i]);
        boolean byHand = Files.exists(file) && !FileCollisionCheck.reduced(site, file, i + 2);
        planned.add(planned(file, text, byHand));
      }
    }
    return planned;
  }

  private boolean elsewhere() {
    return !sceneFolder.equals(outputFolder);
  }

  /** Returns the file of version 1 of an object with versions. */
  private Path source() {
    return sceneFolder.resolve(names.url((ObjectElements.Versioned) site, 0)).normalize();
  }

  private void tellOfOtherFiles(int count) throws IOException {
    List<DocumentElement> apart = tied();
    if (site instanceof ObjectElements.Versioned versioned) {
      apart = versioned.inlines();
      for (int i = count; i < apart.size(); i++) {
        problems.info(
            apart.get(i).location(),
            "the scene no longer uses %s; the file is kept".formatted(names.url(versioned, i)));
      }
    }
    if (elsewhere()) {
      RelativeUrlCheck.warn(scene, apart, outputFolder, problems);
      if (site instanceof ObjectElements.Versioned) {
        ElementNodeMapping original =
            ElementNodeMapping.of(
                DocumentFile.open(source()).document().snapshot(), reader, new ProblemCollector());
        RelativeUrlCheck.warn(original, List.of(), names.of(1, 1).get(0).getParent(), problems);
      }
    }
  }

  private byte[] original(List<NodeView> nodes, Path file, ModelSize size) {
    return writer
        .text(
            nodes,
            scene.file(),
            sceneFolder,
            VersionFileNames.folder(file),
            String.valueOf(file.getFileName()),
            "%s, version 1: %s, as modelled"
                .formatted(site.name(), Pluralizer.of(size.polygons(), "polygon")))
        .getBytes(StandardCharsets.UTF_8);
  }

  private byte[] text(Model model, Path file, int number, SimplificationResult result) {
    return writer
        .text(
            model,
            VersionFileNames.folder(file),
            String.valueOf(file.getFileName()),
            FileCollisionCheck.madeAs(site, number) + Pluralizer.of(result.polygons(), "polygon"))
        .getBytes(StandardCharsets.UTF_8);
  }

  /** Compares a planned file to the existing one; packs the text of an {@code .x3dz} file. */
  static PlannedFile planned(Path file, byte[] text, boolean byHand) throws IOException {
    boolean packed = file.toString().toLowerCase(Locale.ROOT).endsWith(".x3dz");
    byte[] content = packed && !Gzip.compressed(text) ? Gzip.packed(text) : text;
    if (!Files.isRegularFile(file)) {
      return new PlannedFile(file, content, PlannedFile.State.NEW, byHand);
    }
    boolean same = Arrays.equals(Files.readAllBytes(file), content);
    return new PlannedFile(
        file, content, same ? PlannedFile.State.UNCHANGED : PlannedFile.State.CHANGED, byHand);
  }
}
