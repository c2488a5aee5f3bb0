package org.selectiverenderer.authoring.qualities;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.FieldQualityEdits;
import org.selectiverenderer.authoring.switches.SwitchEdits;
import org.selectiverenderer.authoring.versions.ComposedEdit;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.ReferencingScenes;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Gives an object levels of texture and shading, as values of fields that the controller sets: the
 * best level is the object as it is. An object without a Switch is first put into one.
 */
public final class QualityVersionsEdit {
  private static final String SWITCH = "Switch_";

  private final SceneDocument copy;
  private final String before;
  private final ComposedEdit composed;
  private final NodeCatalogue catalogue;
  private final Path scene;
  private final UrlResolver urls;
  private final ReferencingScenes others;
  private final ProblemCollector problems;

  /**
   * A request says which levels are made.
   *
   * @param object the DEF name of the object, or of its Switch
   * @param percents the sides of smaller pictures, in percent, falling; none for no textures
   * @param shading the words of the levels after {@code pixel}; none for no shading
   * @param schemas the schemas that select the levels, the best level's first; none to follow the
   *     metadata of the versions
   */
  public record Request(
      String object, List<Double> percents, List<String> shading, List<String> schemas) {
    /** Copies the lists. */
    public Request {
      percents = List.copyOf(percents);
      shading = List.copyOf(shading);
      schemas = List.copyOf(schemas);
    }
  }

  /**
   * A plan holds the edit and the pictures of a request.
   *
   * @param object the name of the object's Switch
   * @param files the pictures
   * @param edit the change of the document, which is one step
   */
  public record Plan(
      String object, List<FieldQuality> qualities, List<PlannedFile> files, Edit edit) {
    /** Copies the lists. */
    public Plan {
      qualities = List.copyOf(qualities);
      files = List.copyOf(files);
    }
  }

  /** Begins an edit of a document's present state, which is written to its own file. */
  public QualityVersionsEdit(
      SceneDocument document,
      NodeCatalogue catalogue,
      Path scene,
      ContentAccessPolicy access,
      ProblemCollector problems)
      throws IOException {
    this(document, catalogue, scene, scene, access, problems);
  }

  /**
   * Begins an edit of a document's present state.
   *
   * @param scene its file, against whose folder urls are resolved
   * @param output the changed scene's file, in the same folder
   * @param problems receives what is left out, with its place
   */
  public QualityVersionsEdit(
      SceneDocument document,
      NodeCatalogue catalogue,
      Path scene,
      Path output,
      ContentAccessPolicy access,
      ProblemCollector problems)
      throws IOException {
    DocumentSnapshot snapshot = document.snapshot();
    this.copy = SceneDocument.of(document.name(), snapshot.bytes());
    this.before = snapshot.text();
    this.composed = new ComposedEdit(snapshot.text());
    this.catalogue = catalogue;
    this.scene = scene.toAbsolutePath().normalize();
    this.urls = new UrlResolver(folder(), access);
    this.others = new ReferencingScenes(scene, output);
    this.problems = problems;
  }

  private Path folder() {
    Path parent = scene.getParent();
    return parent == null ? scene : parent;
  }

  /**
   * Plans the levels. The document stays as it is, and nothing is written.
   *
   * @return empty if there is nothing to make, which is reported
   * @throws EditRejectedException if the document leaves no room for them
   * @throws IOException if a picture cannot be read or a file is in the way, with a one-line
   *     message that names it
   */
  public Optional<Plan> plan(Request request, PictureScaler scaler) throws IOException {
    Optional<DocumentElement> named = find(request.object());
    if (named.isEmpty()) {
      problems.error(
          SourceLocation.of(copy.name()),
          "there is no node with DEF '" + request.object() + "' in the scene");
      return Optional.empty();
    }
    DocumentElement element = named.get();
    NodeNaming names = new NodeNaming(copy, tree(), problems);
    QualityLevels levels = levels(element, names, request, scaler);
    if (levels.qualities().isEmpty()) {
      problems.error(element.location(), nothing(element, request));
      return Optional.empty();
    }
    // What is inside a new Switch gets its names first, since the Switch moves it.
    perform(levels.changes());
    DocumentElement object = switchOf(request.object());
    perform(new FieldQualityEdits(copy).put(object, levels.qualities()));
    String name = object.def().orElse(request.object());
    boolean same = composed.text().equals(before);
    return Optional.of(
        new Plan(
            name,
            levels.qualities(),
            levels.files(),
            new Edit("Set qualities of " + name, same ? List.of() : composed.changes())));
  }

  private QualityLevels levels(
      DocumentElement element, NodeNaming names, Request request, PictureScaler scaler)
      throws IOException {
    String name = MetadataNames.object(request.object()).replaceFirst("^Transform_", "");
    QualityLevels none = new QualityLevels(List.of(), List.of(), List.of());
    QualityLevels textures =
        request.percents().isEmpty()
            ? none
            : new TextureLevels(copy, names, folder(), urls, scaler, others, problems)
                .of(element, request.percents(), request.schemas(), name);
    return request.shading().isEmpty()
        ? textures
        : textures.and(
            new ShadingLevels(copy, names).of(element, request.shading(), request.schemas(), name));
  }

  private static String nothing(DocumentElement element, Request request) {
    List<String> files = new ArrayList<>();
    element.visit(
        child -> {
          if (child.name().equals("Inline")) {
            child.text("url").ifPresent(files::add);
          }
        });
    String what = request.percents().isEmpty() ? "Appearance" : "ImageTexture with a picture";
    return files.isEmpty()
        ? "'%s' has no %s of its own".formatted(request.object(), what)
        : "'%s' has no %s in this file; make them in the files of its versions: %s"
            .formatted(request.object(), what, String.join(" ", files));
  }

  /** Edits the copy, and notes the change for the document. */
  private void perform(List<TextEdit> changes) {
    Edit edit = new Edit("", changes);
    composed.add(edit.changes());
    if (!edit.isEmpty()) {
      copy.perform(edit);
    }
  }

  private ElementTree tree() {
    return copy.tree()
        .orElseThrow(() -> new EditRejectedException(copy.name() + " is not well-formed XML"));
  }

  /** Finds the Switch of an object, else the node of its name. */
  private Optional<DocumentElement> find(String name) {
    Optional<DocumentElement> node = tree().named(name);
    return node.filter(QualityVersionsEdit::isSwitch)
        .or(
            () ->
                tree()
                    .named(SWITCH + MetadataNames.object(name))
                    .filter(QualityVersionsEdit::isSwitch))
        .or(() -> node);
  }

  private static boolean isSwitch(DocumentElement element) {
    return element.name().equals("Switch");
  }

  /** Returns the Switch of an object, which is put into a new one if it has none. */
  private DocumentElement switchOf(String name) {
    DocumentElement element = find(name).orElseThrow();
    if (isSwitch(element)) {
      return element;
    }
    SwitchEdits edits = new SwitchEdits(new DocumentEnrichment(copy, catalogue), catalogue);
    String wanted = edits.proposedName(element);
    perform(edits.wrap(element, wanted).changes());
    return tree().named(wanted).orElseThrow();
  }
}
