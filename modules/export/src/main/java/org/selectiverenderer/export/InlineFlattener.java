package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.structure.InlinedContent;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Replaces the Inlines whose files hold enriched nodes by Groups with the content of these files:
 * the standard keeps the nodes of an inlined file closed to the ROUTEs of the file around it (X3D
 * 4.0, 9.4.2). Other Inlines stay, such as those of the versions. Prototypes of such files are
 * taken in, too.
 */
final class InlineFlattener {
  private static final String INLINE = "Inline";
  private static final String EXTERNAL = "ExternProtoDeclare";

  /** The largest number of Inlines that are replaced, so that no scene grows without limit. */
  private static final int MOST = 2_000;

  /** The largest number of files that name one another in a row, so that none exhausts the stack. */
  private static final int DEEPEST = 64;

  private static final Set<String> MODULES = Set.of("IMPORT", "EXPORT");

  /** The fields of an Inline that a Group has, too. */
  private static final Set<String> OF_GROUP =
      Set.of(
          "DEF",
          "containerField",
          "class",
          "id",
          "visible",
          "bboxCenter",
          "bboxSize",
          "bboxDisplay");

  private final NodeCatalogue catalogue;
  private final SceneFiles files;
  private final ProblemCollector problems;
  private final ExternPrototypes prototypes;
  private final Map<Path, Boolean> enriched = new HashMap<>();
  private int replaced;
  private int depth;
  private boolean tooDeep;

  InlineFlattener(NodeCatalogue catalogue, UrlResolver resolver, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.files = new SceneFiles(catalogue, resolver, problems);
    this.problems = problems;
    this.prototypes = new ExternPrototypes(files);
  }

  /**
   * Returns the scene as X3D XML without Inlines of enriched nodes; empty if that cannot be done,
   * which is reported.
   *
   * @throws IOException if the scene's file cannot be read
   */
  Optional<SceneDocument> flatten(Path scene) throws IOException {
    return flatten(scene.toRealPath(), scene.toString(), new LinkedHashSet<>());
  }

  private Optional<SceneDocument> flatten(Path file, String name, Set<Path> around)
      throws IOException {
    Optional<SceneDocument> read = files.read(file, name);
    if (read.isEmpty()) {
      return read;
    }
    SceneDocument document = read.get();
    around.add(file);
    boolean whole = true;
    // Each replacement parses the document anew, so that the elements are found anew, too.
    for (Optional<Named> next = next(document, file, around);
        next.isPresent() && whole;
        next = next(document, file, around)) {
      whole = replace(document, file, next.get(), around);
    }
    around.remove(file);
    return whole && !tooDeep ? read : Optional.empty();
  }

  /** An Inline, or the declaration of a prototype, that names a file with enriched nodes. */
  private record Named(DocumentElement element, SceneFiles.Target target) {
    boolean prototype() {
      return element.name().equals(EXTERNAL);
    }
  }

  private Optional<Named> next(SceneDocument document, Path file, Set<Path> around)
      throws IOException {
    for (DocumentElement element : SceneFiles.elements(document)) {
      boolean inline =
          element.name().equals(INLINE)
              && element.use().isEmpty()
              && element.text("load").filter("false"::equals).isEmpty();
      if (!inline && !element.name().equals(EXTERNAL)) {
        continue;
      }
      Optional<SceneFiles.Target> target = files.target(element, file);
      if (target.isEmpty()) {
        continue;
      }
      Named named = new Named(element, target.get());
      // A file that inlines one around it ends there, as in browsers.
      boolean ends = around.contains(target.get().file()) && !named.prototype();
      if (!ends && enriched(element, target.get().file(), around)) {
        return Optional.of(named);
      }
    }
    return Optional.empty();
  }

  /** Returns whether a file, or one that it names, holds enriched nodes. */
  private boolean enriched(DocumentElement by, Path file, Set<Path> around) throws IOException {
    Boolean known = enriched.get(file);
    if (known != null) {
      return known;
    }
    enriched.put(file, false); // a file that inlines itself ends here
    if (depth == DEEPEST) {
      if (!tooDeep) {
        problems.error(
            by.location(),
            "files name one another more than %d files deep; fewer can be exported"
                .formatted(DEEPEST));
      }
      tooDeep = true;
      return false;
    }
    depth++;
    Optional<SceneDocument> read = files.readQuietly(file);
    boolean found = false;
    if (read.isPresent()) {
      DocumentEnrichment nodes = new DocumentEnrichment(read.get(), catalogue);
      found =
          nodes.switches().stream().anyMatch(EnrichedSwitch::enriched)
              || nodes.sensors().stream().anyMatch(EnrichedSensor::enriched)
              || next(read.get(), file, around).isPresent();
    }
    depth--;
    enriched.put(file, found);
    return found;
  }

  /** Replaces an Inline or takes a prototype in; returns whether that could be done. */
  private boolean replace(SceneDocument document, Path file, Named named, Set<Path> around)
      throws IOException {
    DocumentElement element = named.element();
    Path target = named.target().file();
    if (++replaced > MOST) {
      problems.error(
          element.location(),
          "more than %d Inlines and EXTERNPROTOs of files with enriched nodes; fewer can be exported"
              .formatted(MOST));
      return false;
    }
    // A file may take a prototype from one that inlines it.
    boolean circle = around.contains(target);
    Optional<SceneDocument> content =
        circle ? files.readQuietly(target) : flatten(target, files.display(target), around);
    if (content.isEmpty()) {
      return false;
    }
    Optional<String> obstacle =
        named.prototype()
            ? prototypes.obstacle(element, content.get(), named.target(), circle)
            : obstacle(document, element, content.get());
    if (obstacle.isPresent()) {
      problems.error(element.location(), obstacle.get());
      return false;
    }
    try {
      List<TextEdit> edits =
          named.prototype()
              ? prototypes.edits(document, element, content.get(), file, named.target())
              : edits(document, element, content.get(), file, target);
      document.perform(new Edit("Export", edits));
      return true;
    } catch (EditRejectedException e) {
      problems.error(element.location(), String.valueOf(e.getMessage()));
      return false;
    }
  }

  /** Returns why the content of a file cannot stand in the place of an Inline. */
  private Optional<String> obstacle(
      SceneDocument document, DocumentElement inline, SceneDocument content) {
    String what = "the content of the inlined file, which has enriched nodes, ";
    if (SceneFiles.elements(document).stream().anyMatch(element -> imports(element, inline))) {
      return Optional.of(what + "is named by an IMPORT, so it cannot take the Inline's place");
    }
    for (DocumentElement at = inline; at.parent().isPresent(); at = at.parent().get()) {
      if (at.name().equals("ProtoBody")) {
        return Optional.of(what + "is inlined by a prototype; inline it in the scene");
      }
    }
    for (DocumentElement element : SceneFiles.elements(content)) {
      if (MODULES.contains(element.name())) {
        return Optional.of(what + "uses " + element.name() + "; remove the statement");
      }
      if (element.name().equals("unit")) {
        return Optional.of(what + "has units of its own; write it in the scene's units");
      }
    }
    return content.tree().orElseThrow().scene().isEmpty()
        ? Optional.of(what + "has no Scene")
        : Optional.empty();
  }

  private static boolean imports(DocumentElement element, DocumentElement inline) {
    return element.name().equals("IMPORT")
        && inline.def().isPresent()
        && element.text("inlineDEF").equals(inline.def());
  }

  private List<TextEdit> edits(
      SceneDocument document, DocumentElement inline, SceneDocument content, Path file, Path from) {
    var tree = document.tree().orElseThrow();
    DocumentElement scene = tree.scene().orElseThrow();
    List<DocumentElement> elements = content.tree().orElseThrow().scene().orElseThrow().children();
    List<TextEdit> changes = new ArrayList<>(files.urls(content, from, file));
    changes.addAll(
        PrototypeNames.edits(
            content,
            PrototypeNames.renamed(
                PrototypeNames.declared(content), PrototypeNames.declared(document))));
    InlinedContent inside =
        new InlinedContent(content, elements, new UniqueNameGenerator(tree, inline), changes);
    List<String> first = new ArrayList<>();
    List<String> last = new ArrayList<>();
    List<String> group = new ArrayList<>(List.of(groupTag(document, inline)));
    inline.children().forEach(child -> group.add("  " + document.text(child).strip()));
    for (DocumentElement element : elements) {
      List<String> lines = inside.lines(element);
      if (PrototypeNames.DECLARATIONS.contains(element.name())) {
        first.addAll(lines);
      } else if (element.name().equals("ROUTE")) {
        last.addAll(lines);
      } else {
        lines.forEach(line -> group.add("  " + line));
      }
    }
    group.add("</Group>");
    List<TextEdit> edits = new ArrayList<>();
    if (!first.isEmpty()) {
      edits.add(document.layout().insertFirst(scene, first));
    }
    edits.add(document.layout().replace(inline, group));
    if (!last.isEmpty()) {
      edits.add(document.layout().insertLast(scene, last));
    }
    edits.addAll(uses(document, inline));
    edits.addAll(new HeadMerger(document).include(content));
    edits.sort(Comparator.comparingInt(TextEdit::from));
    return edits;
  }

  private static String groupTag(SceneDocument document, DocumentElement inline) {
    StringBuilder tag = new StringBuilder("<Group");
    for (SourceAttribute attribute : document.tag(inline).attributes()) {
      if (OF_GROUP.contains(attribute.name())) {
        tag.append(SourceFormatter.written(attribute.name(), attribute.value(), '\''));
      }
    }
    return tag.append('>').toString();
  }

  /** Makes Groups of the other places where the Inline is used. */
  private static List<TextEdit> uses(SceneDocument document, DocumentElement inline) {
    List<TextEdit> edits = new ArrayList<>();
    for (DocumentElement element : SceneFiles.elements(document)) {
      if (element.name().equals(INLINE)
          && element.use().isPresent()
          && element.use().equals(inline.def())) {
        int at = element.start() + 1;
        edits.add(new TextEdit(at, at + INLINE.length(), "Group"));
        int close = element.end() - INLINE.length() - 1;
        if (document.text(element).endsWith("</" + INLINE + ">")) {
          edits.add(new TextEdit(close, close + INLINE.length(), "Group"));
        }
      }
    }
    return edits;
  }

}
