package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * Maps elements of the document to anchors, which the running scene resolves, and picked anchors
 * back to elements.
 */
final class SourceAnchorResolver {
  private final SceneDocument document;

  SourceAnchorResolver(SceneDocument document) {
    this.document = document;
  }

  /** The element of the whole scene; empty while the text is not well formed. */
  Optional<DocumentElement> scene() {
    return document.tree().map(tree -> tree.scene().orElse(tree.root()));
  }

  /** Returns the anchors of an element and of those around it, the nearest first. */
  List<SourceAnchor> of(DocumentElement element) {
    List<SourceAnchor> anchors = new ArrayList<>();
    Optional<DocumentElement> at = Optional.of(element).filter(DocumentElement::attached);
    while (at.isPresent()) {
      DocumentElement around = at.get();
      SourceLocation place = document.location(around.start());
      anchors.add(new SourceAnchor(name(around), place.line(), place.column()));
      at = around.parent();
    }
    return anchors;
  }

  /** Returns the name of an element in the scene; names in a prototype mean nothing there. */
  private static Optional<String> name(DocumentElement element) {
    return ElementScope.of(element).parent().isPresent()
        ? Optional.empty()
        : element.def().or(element::use);
  }

  /** Returns an element as the running scene finds it. */
  SelectedNode node(DocumentElement element) {
    boolean inside = Placement.transforms(document, element);
    return new SelectedNode(element, of(element), inside, use(element));
  }

  /** Returns the elements as the running scene finds them; those that are gone are left out. */
  List<SelectedNode> nodes(List<DocumentElement> elements) {
    return elements.stream().filter(DocumentElement::attached).map(this::node).toList();
  }

  /** Returns how many elements before one are the same node: its DEF and its USEs. */
  private int use(DocumentElement element) {
    Optional<String> name = element.use();
    if (name.isEmpty() || document.tree().isEmpty()) {
      return 0;
    }
    int[] before = {0};
    ElementScope.visit(
        element,
        each -> {
          if (each.start() < element.start()
              && (each.use().equals(name) || each.def().equals(name))) {
            before[0]++;
          }
        });
    return before[0];
  }

  /**
   * Finds a picked element: by its position while the text is still the one that was loaded, else
   * by its name in the scene.
   */
  Optional<DocumentElement> element(PreviewController.Picked picked) {
    SourceAnchor anchor = picked.anchor();
    Optional<ElementTree> tree = document.tree();
    Optional<DocumentElement> placed =
        document.revision() == picked.revision()
            ? tree.flatMap(found -> at(found, document.offset(anchor.line(), anchor.column())))
            : Optional.empty();
    return placed.or(() -> tree.flatMap(found -> anchor.def().flatMap(found::named)));
  }

  private static Optional<DocumentElement> at(ElementTree tree, int start) {
    return tree.at(start).filter(element -> element.start() == start);
  }
}
