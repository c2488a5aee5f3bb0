package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
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
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.authoring.packaging.UrlFields;
import org.selectiverenderer.authoring.packaging.UrlFields.UrlField;
import org.selectiverenderer.authoring.structure.InlinedContent;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Replaces the Inlines whose files hold enriched nodes by Groups with the content of these files:
 * the standard keeps the nodes of an inlined file closed to the ROUTEs of the file around it (X3D
 * 4.0, 9.4.2). Other Inlines stay, such as those of the versions.
 */
final class InlineFlattener {
  private static final String INLINE = "Inline";

  /** The largest number of Inlines that are replaced, so that no scene grows without limit. */
  private static final int MOST = 2_000;

  /** Statements that must stand directly in a Scene, before and after its nodes. */
  private static final Set<String> DECLARATIONS = Set.of("ProtoDeclare", "ExternProtoDeclare");

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
  private final UrlResolver resolver;
  private final ProblemCollector problems;
  private final Map<Path, Boolean> enriched = new HashMap<>();
  private int replaced;

  InlineFlattener(NodeCatalogue catalogue, UrlResolver resolver, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.resolver = resolver;
    this.problems = problems;
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
    Optional<SceneDocument> read = read(file, name);
    if (read.isEmpty()) {
      return read;
    }
    SceneDocument document = read.get();
    around.add(file);
    boolean whole = prototypesHere(document, file, around);
    // Each replacement parses the document anew, so that the elements are found anew, too.
    for (Optional<Inlined> next = next(document, file, around);
        next.isPresent() && whole;
        next = next(document, file, around)) {
      whole = replace(document, file, next.get(), around);
    }
    around.remove(file);
    return whole ? read : Optional.empty();
  }

  /** Reports prototypes of other files that hold enriched nodes; returns whether there are none. */
  private boolean prototypesHere(SceneDocument document, Path file, Set<Path> around)
      throws IOException {
    boolean none = true;
    for (DocumentElement element : elements(document)) {
      if (elsewhere(element, file, around)) {
        none = false;
        problems.error(
            element.location(),
            "the prototype %s comes from a file with enriched nodes, which no ROUTE of the scene"
                    .formatted(element.text("name").orElse(""))
                + " reaches; declare the prototype in the scene");
      }
    }
    return none;
  }

  private boolean elsewhere(DocumentElement element, Path file, Set<Path> around)
      throws IOException {
    if (!element.name().equals("ExternProtoDeclare")) {
      return false;
    }
    Optional<Path> target = target(element, file);
    return target.isPresent() && !around.contains(target.get()) && enriched(target.get(), around);
  }

  /** An Inline of a file with enriched nodes. */
  private record Inlined(DocumentElement element, Path file) {}

  private Optional<Inlined> next(SceneDocument document, Path file, Set<Path> around)
      throws IOException {
    for (DocumentElement inline : elements(document)) {
      if (!inline.name().equals(INLINE)
          || inline.use().isPresent()
          || inline.text("load").filter("false"::equals).isPresent()) {
        continue;
      }
      Optional<Path> target = target(inline, file);
      if (target.isPresent() && !around.contains(target.get()) && enriched(target.get(), around)) {
        return Optional.of(new Inlined(inline, target.get()));
      }
    }
    return Optional.empty();
  }

  /** Returns the file that a url field names, if it is one that the scene may read. */
  private Optional<Path> target(DocumentElement element, Path file) {
    for (String named : MFStringParser.strings(element.text("url").orElse(""))) {
      int fragment = named.indexOf('#');
      String url = fragment < 0 ? named : named.substring(0, fragment);
      if (resolver.resolve(url, BaseUrl.folder(folder(file)))
          instanceof UrlResolver.Target.Found found) {
        return found.content().file();
      }
    }
    return Optional.empty();
  }

  /** Returns whether a file, or one that it inlines, holds enriched nodes. */
  private boolean enriched(Path file, Set<Path> around) throws IOException {
    Boolean known = enriched.get(file);
    if (known != null) {
      return known;
    }
    enriched.put(file, false); // a file that inlines itself ends here
    Optional<SceneDocument> read = readQuietly(file);
    boolean found = false;
    if (read.isPresent()) {
      DocumentEnrichment nodes = new DocumentEnrichment(read.get(), catalogue);
      found =
          nodes.switches().stream().anyMatch(EnrichedSwitch::enriched)
              || nodes.sensors().stream().anyMatch(EnrichedSensor::enriched)
              || next(read.get(), file, around).isPresent();
      for (DocumentElement element : elements(read.get())) {
        found = found || elsewhere(element, file, around);
      }
    }
    enriched.put(file, found);
    return found;
  }

  /** Replaces an Inline; returns whether that could be done. */
  private boolean replace(SceneDocument document, Path file, Inlined inlined, Set<Path> around)
      throws IOException {
    DocumentElement inline = inlined.element();
    if (++replaced > MOST) {
      problems.error(
          inline.location(),
          "more than %d Inlines of files with enriched nodes; fewer can be exported"
              .formatted(MOST));
      return false;
    }
    Optional<SceneDocument> content =
        flatten(inlined.file(), resolver.display(inlined.file()), around);
    if (content.isEmpty()) {
      return false;
    }
    Optional<String> obstacle = obstacle(document, inline, content.get());
    if (obstacle.isPresent()) {
      problems.error(inline.location(), obstacle.get());
      return false;
    }
    try {
      document.perform(
          new Edit("Export", edits(document, inline, content.get(), file, inlined.file())));
      return true;
    } catch (EditRejectedException e) {
      problems.error(inline.location(), String.valueOf(e.getMessage()));
      return false;
    }
  }

  /** Returns why the content of a file cannot stand in the place of an Inline. */
  private Optional<String> obstacle(
      SceneDocument document, DocumentElement inline, SceneDocument content) {
    String what = "the content of the inlined file, which has enriched nodes, ";
    if (elements(document).stream().anyMatch(element -> imports(element, inline))) {
      return Optional.of(what + "is named by an IMPORT, so it cannot take the Inline's place");
    }
    for (DocumentElement at = inline; at.parent().isPresent(); at = at.parent().get()) {
      if (at.name().equals("ProtoBody")) {
        return Optional.of(what + "is inlined by a prototype; inline it in the scene");
      }
    }
    for (DocumentElement element : elements(content)) {
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
    List<TextEdit> changes = new ArrayList<>(urls(content, from, file));
    changes.addAll(prototypes(content, document));
    InlinedContent inside =
        new InlinedContent(content, elements, new UniqueNameGenerator(tree, inline), changes);
    List<String> first = new ArrayList<>();
    List<String> last = new ArrayList<>();
    List<String> group = new ArrayList<>(List.of(groupTag(document, inline)));
    inline.children().forEach(child -> group.add("  " + document.text(child).strip()));
    for (DocumentElement element : elements) {
      List<String> lines = inside.lines(element);
      if (DECLARATIONS.contains(element.name())) {
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
    for (DocumentElement element : elements(document)) {
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

  /** Returns the changes that make the urls of a file relative to another one. */
  private List<TextEdit> urls(SceneDocument content, Path from, Path to) {
    List<TextEdit> edits = new ArrayList<>();
    for (UrlField field : new UrlFields(catalogue).of(elements(content))) {
      List<String> now =
          field.urls().stream()
              .map(url -> UrlRelativizer.turned(url, folder(from), folder(to)))
              .toList();
      if (!now.equals(field.urls())) {
        edits.add(
            content
                .layout()
                .attribute(field.element(), field.attribute(), FieldValueFormatter.strings(now)));
      }
    }
    return edits;
  }

  /** Renames the prototypes of a file whose names the other one has, too. */
  private static List<TextEdit> prototypes(SceneDocument content, SceneDocument into) {
    Set<String> taken = declared(into);
    Set<String> own = declared(content);
    Map<String, String> renamed = new HashMap<>();
    for (String name : own) {
      String free = name;
      for (int i = 2; taken.contains(free) || i > 2 && own.contains(free); i++) {
        free = name + "_" + i;
      }
      if (!free.equals(name)) {
        renamed.put(name, free);
        taken.add(free);
      }
    }
    List<TextEdit> edits = new ArrayList<>();
    for (DocumentElement element : elements(content)) {
      boolean names =
          DECLARATIONS.contains(element.name()) || element.name().equals("ProtoInstance");
      String now = names ? renamed.get(element.text("name").orElse("")) : null;
      if (now != null) {
        edits.add(content.layout().attribute(element, "name", now));
      }
    }
    return edits;
  }

  private static Set<String> declared(SceneDocument document) {
    Set<String> names = new LinkedHashSet<>();
    elements(document).stream()
        .filter(element -> DECLARATIONS.contains(element.name()))
        .forEach(element -> element.text("name").ifPresent(names::add));
    return names;
  }

  private static List<DocumentElement> elements(SceneDocument document) {
    List<DocumentElement> all = new ArrayList<>();
    document.tree().orElseThrow().root().visit(all::add);
    return all;
  }

  private static Path folder(Path file) {
    Path folder = file.getParent();
    return folder == null ? file : folder;
  }

  /** Reads a file that may be anything; empty for what is no scene or not well-formed. */
  private Optional<SceneDocument> readQuietly(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    return read(file, file.toString(), new ProblemCollector());
  }

  private Optional<SceneDocument> read(Path file, String name) throws IOException {
    return read(file, name, problems);
  }

  private Optional<SceneDocument> read(Path file, String name, ProblemCollector to)
      throws IOException {
    Optional<XmlConversion> foreign = XmlConversion.of(file);
    SceneDocument document;
    if (foreign.isPresent()) {
      Optional<String> xml = foreign.get().xml(catalogue, to);
      if (xml.isEmpty()) {
        return Optional.empty();
      }
      document = SceneDocument.of(name, xml.get().getBytes(StandardCharsets.UTF_8));
    } else {
      document = SceneDocument.of(name, InputFileReader.bytes(file));
    }
    if (document.tree().isEmpty()) {
      document.fault().ifPresent(fault -> to.error(fault.location(), fault.message()));
      return Optional.empty();
    }
    Optional<String> locked = document.locked();
    if (locked.isPresent()) {
      to.error(SourceLocation.of(name), locked.get());
      return Optional.empty();
    }
    return Optional.of(document);
  }
}
