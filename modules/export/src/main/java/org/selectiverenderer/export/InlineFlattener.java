package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
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

  /** The largest number of files that name one another in a row, as each takes of the stack. */
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
  private final Map<Path, Content> contents = new HashMap<>();
  private int replaced;

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
    if (around.size() > DEEPEST) {
      problems.error(
          document.tree().orElseThrow().root().location(),
          "files name one another more than %d files deep; fewer can be exported"
              .formatted(DEEPEST));
      return Optional.empty();
    }
    boolean whole = true;
    // Each replacement parses the document anew, so that the elements are found anew, too.
    for (Optional<Named> next = next(document, file, around);
        next.isPresent() && whole;
        next = next(document, file, around)) {
      whole = replace(document, file, next.get(), around);
    }
    if (whole && around.size() > 1) {
      empty(document, file, around);
    }
    around.remove(file);
    return whole ? read : Optional.empty();
  }

  /**
   * Makes Groups without content of the Inlines that end a circle of files within the scene, so
   * that they do not begin it anew in the file around. An Inline of the scene itself stays.
   */
  private void empty(SceneDocument document, Path file, Set<Path> around) throws IOException {
    Path scene = around.iterator().next();
    List<TextEdit> edits = new ArrayList<>();
    for (DocumentElement element : SceneFiles.elements(document)) {
      Optional<SceneFiles.Target> target =
          inline(element) ? files.target(element, file) : Optional.empty();
      if (target.isPresent()
          && around.contains(target.get().file())
          && !target.get().file().equals(scene)) {
        List<String> group = List.of(groupTag(document, element), "</Group>");
        edits.add(document.layout().replace(element, group));
        edits.addAll(uses(document, element));
      }
    }
    if (!edits.isEmpty()) {
      edits.sort(Comparator.comparingInt(TextEdit::from));
      try {
        document.perform(new Edit("Export", edits));
      } catch (EditRejectedException e) {
        throw new IOException(e.getMessage(), e);
      }
    }
  }

  private static boolean inline(DocumentElement element) {
    return element.name().equals(INLINE)
        && element.use().isEmpty()
        && element.text("load").filter("false"::equals).isEmpty();
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
      if (!inline(element) && !element.name().equals(EXTERNAL)) {
        continue;
      }
      Optional<SceneFiles.Target> target = files.target(element, file);
      if (target.isEmpty()) {
        continue;
      }
      Named named = new Named(element, target.get());
      // A file that inlines one around it ends there, as in browsers.
      boolean ends = around.contains(target.get().file()) && !named.prototype();
      if (!ends && enriched(target.get().file(), around)) {
        return Optional.of(named);
      }
    }
    return Optional.empty();
  }

  /**
   * The content of a file, as far as it decides whether the file is taken in.
   *
   * @param enriched whether it has enriched nodes of its own
   * @param inlines the files of its Inlines
   * @param prototypes the files of its EXTERNPROTOs
   */
  private record Content(boolean enriched, Set<Path> inlines, Set<Path> prototypes) {}

  /**
   * Returns whether a file, or one that it names, holds enriched nodes; an Inline of a file around
   * it has no content.
   */
  private boolean enriched(Path file, Set<Path> around) throws IOException {
    Set<Path> seen = new HashSet<>();
    Deque<Path> left = new ArrayDeque<>(List.of(file));
    while (!left.isEmpty()) {
      Content content = content(left.poll());
      if (content.enriched()) {
        return true;
      }
      content.prototypes().stream().filter(seen::add).forEach(left::add);
      content.inlines().stream()
          .filter(inlined -> !around.contains(inlined) && seen.add(inlined))
          .forEach(left::add);
    }
    return false;
  }

  private Content content(Path file) throws IOException {
    Content known = contents.get(file);
    if (known != null) {
      return known;
    }
    Optional<SceneDocument> read = files.readQuietly(file);
    boolean nodes = false;
    Set<Path> inlines = new LinkedHashSet<>();
    Set<Path> externals = new LinkedHashSet<>();
    if (read.isPresent()) {
      DocumentEnrichment own = new DocumentEnrichment(read.get(), catalogue);
      nodes =
          own.switches().stream().anyMatch(EnrichedSwitch::controlled)
              || own.sensors().stream().anyMatch(EnrichedSensor::enriched);
      for (DocumentElement element : SceneFiles.elements(read.get())) {
        boolean external = element.name().equals(EXTERNAL);
        if (external || inline(element)) {
          Set<Path> named = external ? externals : inlines;
          files.target(element, file).ifPresent(target -> named.add(target.file()));
        }
      }
    }
    Content content = new Content(nodes, inlines, externals);
    contents.put(file, content);
    return content;
  }

  /** Replaces an Inline or takes a prototype in; returns whether that could be done. */
  private boolean replace(SceneDocument document, Path file, Named named, Set<Path> around)
      throws IOException {
    DocumentElement element = named.element();
    Path target = named.target().file();
    if (++replaced > MOST) {
      problems.error(
          element.location(),
          "more than %d Inlines and EXTERNPROTOs of files with enriched nodes; export fewer"
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
