package org.selectiverenderer.authoring.structure;

import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Refuses edits that would give the schema metadata of a Switch's choices to other choices: it
 * belongs to them by their order, which only {@code authoring.switches} changes together with it.
 */
final class ChoiceGuard {
  private final DocumentEnrichment enrichment;

  ChoiceGuard(SceneDocument document, NodeCatalogue catalogue) {
    enrichment = new DocumentEnrichment(document, catalogue);
  }

  private static boolean choices(EnrichedSwitch node, DocumentElement element) {
    return node.choices().stream().anyMatch(choice -> choice.element() == element);
  }

  /** Refuses to take an element away that is a choice with metadata. */
  void taken(DocumentElement element) {
    element
        .parent()
        .filter(parent -> parent.name().equals("Switch"))
        .flatMap(enrichment::switchNode)
        .filter(node -> node.enriched() && choices(node, element))
        .ifPresent(node -> refuse(node, "move or delete them one by one"));
  }

  /** Refuses to put something before a choice with metadata. */
  void given(ChildPosition position) {
    DocumentElement parent = position.parent();
    if (!parent.name().equals("Switch")) {
      return;
    }
    enrichment
        .switchNode(parent)
        .filter(EnrichedSwitch::enriched)
        .filter(
            node ->
                parent.children().subList(position.index(), parent.children().size()).stream()
                    .anyMatch(each -> choices(node, each)))
        .ifPresent(node -> refuse(node, "add one in the form of the Switch"));
  }

  private static void refuse(EnrichedSwitch node, String instead) {
    throw new EditRejectedException(
        "The choices of %s have metadata in their order; %s".formatted(node.name(), instead));
  }
}
