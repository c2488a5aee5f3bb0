package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.EntityTable;

/**
 * What the form panel says of an element that has no metadata form.
 *
 * @param path names of the elements around it, from the outermost
 * @param formed the nearest Switch or ProximitySensor that it stands in, or the Switch with its
 *     versions
 * @param advice a sentence about what can be done with it
 * @param versions whether versions of it can be made
 */
record ElementSummary(
    String path, Optional<DocumentElement> formed, String advice, boolean versions) {
  /** Most characters of an entity that are shown. */
  private static final int SHOWN = 600;

  static ElementSummary of(SceneDocument document, NodeCatalogue catalogue, DocumentElement node) {
    List<String> names = new ArrayList<>();
    Optional<DocumentElement> around = Optional.empty();
    for (Optional<DocumentElement> at = node.parent(); at.isPresent(); at = at.get().parent()) {
      DocumentElement parent = at.get();
      names.add(parent.toString());
      boolean form = parent.name().equals("Switch") || parent.name().equals("ProximitySensor");
      around = around.isEmpty() && form ? at : around;
    }
    Collections.reverse(names);
    boolean object =
        node.name().equals("ProtoInstance")
            || catalogue
                .find(node.name())
                .filter(
                    type ->
                        type.is("X3DGroupingNode")
                            || type.is("X3DShapeNode")
                            || inlines(node.name()))
                .isPresent();
    Optional<DocumentElement> versions = object ? versions(node) : Optional.empty();
    boolean free = around.isEmpty() && versions.isEmpty() && node.use().isEmpty();
    String advice;
    if (node.isReference()) {
      advice = reference(document, node);
    } else if (around.isPresent()) {
      advice = Texts.of("form.part", around.get().toString());
    } else if (versions.isPresent()) {
      advice = Texts.of("form.holds", versions.get().toString());
    } else if (object && free) {
      advice = Texts.of("form.versions");
    } else {
      advice = Texts.of("form.formless");
    }
    return new ElementSummary(
        String.join(" \u203a ", names),
        around.or(() -> versions),
        document.locked().orElse(advice),
        object && free && document.locked().isEmpty());
  }

  /** Returns the Switch that is all that a node holds, as where versions of it were made. */
  private static Optional<DocumentElement> versions(DocumentElement node) {
    List<DocumentElement> held =
        node.children().stream().filter(child -> !child.name().startsWith("Metadata")).toList();
    return held.size() == 1 && held.get(0).name().equals("Switch")
        ? Optional.of(held.get(0))
        : Optional.empty();
  }

  /** Describes what an entity reference stands for. */
  private static String reference(SceneDocument document, DocumentElement node) {
    String name = node.name().substring(1, node.name().length() - 1);
    Optional<EntityTable.Declared> declared = document.entities().find(name);
    if (declared.isEmpty()) {
      return Texts.of("node.referenceNowhere");
    }
    String line = Integer.toString(document.location(declared.get().offset()).line());
    return declared.get().value().isPresent()
        ? Texts.of("node.reference", line) + "\n\n" + shortened(declared.get().value().get())
        : Texts.of("node.referenceFar", node.name(), line);
  }

  private static String shortened(String text) {
    return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + " ...";
  }

  private static boolean inlines(String name) {
    return name.equals("Inline");
  }
}
