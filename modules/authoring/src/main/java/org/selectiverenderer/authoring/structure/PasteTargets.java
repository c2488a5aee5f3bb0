package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds where nodes go that are pasted while an element is selected, and says why they cannot. */
final class PasteTargets {
  private static final int EXAMPLES = 3;

  private final SceneDocument document;
  private final Containment containment;
  private final NodeCatalogue catalogue;

  PasteTargets(SceneDocument document, Containment containment, NodeCatalogue catalogue) {
    this.document = document;
    this.containment = containment;
    this.catalogue = catalogue;
  }

  /** Returns where nodes go that are pasted while an element is selected. */
  ChildPosition positionFor(DocumentElement target, SceneFragment fragment) {
    ChildPosition into = ChildPosition.last(target);
    boolean same =
        fragment.elements().size() == 1
            && bare(document.text(target))
                .equals(bare(fragment.document().text(fragment.elements().get(0))));
    Optional<ChildPosition> beside = target.parent().map(parent -> ChildPosition.after(target));
    Optional<ChildPosition> first = same ? beside : Optional.of(into);
    Optional<ChildPosition> second = same ? Optional.of(into) : beside;
    List<DocumentElement> elements = fragment.elements();
    return first
        .filter(at -> misfit(elements, at.parent(), Set.of()).isEmpty())
        .or(() -> second.filter(at -> misfit(elements, at.parent(), Set.of()).isEmpty()))
        .orElseThrow(() -> new EditRejectedException(nowhere(elements, target)));
  }

  /** Returns a node's text by which it knows its copies: without numbers of names, white space. */
  private static String bare(String text) {
    return text.replaceAll("_[1-9][0-9]*(?=['\"])|\\s+", "");
  }

  /** Returns the first element that no free field of a parent takes; empty if all fit. */
  private Optional<DocumentElement> misfit(
      List<DocumentElement> elements, DocumentElement parent, Set<DocumentElement> leaving) {
    FieldOccupancy fields = new FieldOccupancy(containment, parent, leaving);
    return elements.stream().filter(each -> fields.give(each).isEmpty()).findFirst();
  }

  private String nowhere(List<DocumentElement> elements, DocumentElement target) {
    DocumentElement misfit = misfit(elements, target, Set.of()).orElseGet(() -> elements.get(0));
    if (containment.accepts(target, misfit)) {
      return taken(misfit, target);
    }
    return "%s can go neither into %s nor beside it; %s".formatted(misfit, target, homes(misfit));
  }

  /** Returns why a parent does not take a child that it could have. */
  String taken(DocumentElement child, DocumentElement parent) {
    return "%s takes only one node as its %s and has one already; delete that first"
        .formatted(
            parent,
            containment
                .place(parent, child, Set.of())
                .flatMap(Containment.Place::field)
                .orElse("value"));
  }

  /** Returns a clause that says which elements take a node: of this scene, else by their types. */
  String homes(DocumentElement node) {
    List<DocumentElement> here = new ArrayList<>();
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            each -> {
              if (here.size() < EXAMPLES && containment.accepts(each, node)) {
                here.add(each);
              }
            });
    if (!here.isEmpty()) {
      return "select a node that takes it, such as "
          + here.stream()
              .map(each -> "%s in line %d".formatted(each, document.location(each.start()).line()))
              .collect(Collectors.joining(" or "));
    }
    List<String> types = new NodePalette(document, catalogue).parents(node);
    return types.isEmpty()
        ? "no node takes it"
        : "insert a node that takes it first: " + String.join(", ", types);
  }
}
