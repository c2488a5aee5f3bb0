package org.selectiverenderer.export;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A page loads these versions after its first picture: those that are not shown at the beginning,
 * which often are the largest. Their Inlines have {@code load='false'} in the scene.
 */
final class LaterVersions {
  /**
   * This version is loaded later.
   *
   * @param object DEF of the Switch
   * @param choice the place of the version in it
   * @param inlines DEF names of the version's Inlines
   * @param files the files that these name, relative to the scene
   */
  private record Version(String object, int choice, List<String> inlines, List<String> files) {}

  private final PackagedFile scene;
  private final List<Version> versions;

  private LaterVersions(PackagedFile scene, List<Version> versions) {
    this.scene = scene;
    this.versions = List.copyOf(versions);
  }

  /** Returns a scene all of whose versions are loaded at once. */
  static LaterVersions none(PackagedFile scene) {
    return new LaterVersions(scene, List.of());
  }

  /**
   * Finds what can be loaded later in an exported scene, in X3D XML.
   *
   * @param condition the condition that the page begins with
   * @throws IOException if the scene cannot be read, with a sentence
   */
  static LaterVersions of(
      PackagedFile scene, Condition condition, int seed, NodeCatalogue catalogue)
      throws IOException {
    SceneDocument document =
        SceneDocument.of(scene.target().toString(), scene.changed().orElseThrow());
    if (document.tree().isEmpty() || document.locked().isPresent()) {
      return none(scene);
    }
    DocumentEnrichment enrichment = new DocumentEnrichment(document, catalogue);
    List<EnrichedSwitch> objects =
        enrichment.switches().stream().filter(EnrichedSwitch::enriched).toList();
    List<Integer> first =
        ControlledNodes.of(enrichment, catalogue, new ProblemCollector()).choices(condition, seed);
    Set<String> known = known(document);
    NodeNamer names = new NodeNamer(document);
    List<Version> versions = new ArrayList<>();
    List<TextEdit> edits = new ArrayList<>();
    Set<DocumentElement> later = new HashSet<>(); // an object may be in another's version
    for (int i = 0; i < objects.size(); i++) {
      EnrichedSwitch object = objects.get(i);
      for (EnrichedSwitch.ChoiceNode choice : object.choices()) {
        // The condition selective begins with what the file shows, and names no choices.
        boolean begins = !first.isEmpty() && choice.index() == first.get(i);
        if (begins || choice.index() == object.whichChoice()) {
          continue;
        }
        List<String> inlines = new ArrayList<>();
        List<String> files = new ArrayList<>();
        for (DocumentElement inline : inlines(choice.element(), known)) {
          if (later.add(inline)) {
            edits.add(document.layout().attribute(inline, "load", "false"));
          }
          inlines.add(names.name(inline, "Later"));
          files.addAll(MFStringParser.strings(inline.text("url").orElse("")));
        }
        if (!inlines.isEmpty()) {
          versions.add(new Version(object.name(), choice.index(), inlines, files));
        }
      }
    }
    if (edits.isEmpty()) {
      return none(scene);
    }
    edits.addAll(0, names.edits()); // DEF before load, where both are new
    edits.sort(Comparator.comparingInt(TextEdit::from));
    document.perform(new Edit("Later", edits));
    return new LaterVersions(
        new PackagedFile(scene.target(), scene.source(), Optional.of(document.snapshot().bytes())),
        versions);
  }

  /** Returns the Inlines of a version that nothing else in the scene has to do with. */
  private static List<DocumentElement> inlines(DocumentElement version, Set<String> known) {
    List<DocumentElement> found = new ArrayList<>();
    version.visit(
        element -> {
          if (element.name().equals("Inline")
              && element.use().isEmpty()
              && !element.isReference()
              && element.text("load").isEmpty()
              && !shared(element, version, known)) {
            found.add(element);
          }
        });
    return found;
  }

  /** Returns whether an element, or what of a version is around it, has one of some names. */
  private static boolean shared(
      DocumentElement element, DocumentElement version, Set<String> known) {
    for (DocumentElement at = element; ; at = at.parent().orElseThrow()) {
      if (at.def().filter(known::contains).isPresent()) {
        return true;
      }
      if (at == version) {
        return false;
      }
    }
  }

  /**
   * Returns the names of the nodes that are used again, or that statements name. A ROUTE of a
   * choice does not count: it makes nobody else show what is in the Switch.
   */
  private static Set<String> known(SceneDocument document) {
    Set<String> names = new HashSet<>();
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              element.use().ifPresent(names::add);
              element.text("inlineDEF").ifPresent(names::add);
              for (String end : List.of("from", "to")) {
                String field = element.text(end + "Field").orElse("");
                if (!ControlledNodes.CHOICE_FIELDS.contains(field)) {
                  element.text(end + "Node").ifPresent(names::add);
                }
              }
            });
    return names;
  }

  /** Returns the scene, whose Inlines of these versions are not loaded. */
  PackagedFile scene() {
    return scene;
  }

  /** Tells the page of them in its description, as web/src/scene/later.ts reads it. */
  void describe(ObjectNode json) {
    if (versions.isEmpty()) {
      return;
    }
    ArrayNode list = json.putArray("later");
    for (Version version : versions) {
      ObjectNode each = list.addObject();
      each.put("object", version.object());
      each.put("choice", version.choice());
      version.inlines().forEach(each.putArray("inlines")::add);
      version.files().forEach(each.putArray("files")::add);
    }
  }
}
