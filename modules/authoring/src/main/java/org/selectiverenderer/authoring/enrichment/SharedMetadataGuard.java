package org.selectiverenderer.authoring.enrichment;

import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** Rejects edits of metadata that other nodes share by USE. */
final class SharedMetadataGuard {
  private final SceneDocument document;

  SharedMetadataGuard(SceneDocument document) {
    this.document = document;
  }

  /**
   * Checks that an element may be changed or removed.
   *
   * @throws EditRejectedException if the element, a descendant, or metadata around it is referenced
   *     by USE
   */
  void free(DocumentElement element) {
    element.visit(this::unused);
    extensible(element);
  }

  /**
   * Checks that something may be added to an element.
   *
   * @throws EditRejectedException if the element or metadata around it is referenced by USE
   */
  void extensible(DocumentElement element) {
    Optional<DocumentElement> each = Optional.of(element);
    while (each.filter(MetadataElement::isMetadata).isPresent()) {
      unused(each.get());
      each = each.get().parent();
    }
  }

  private void unused(DocumentElement element) {
    ElementTree tree = document.tree().orElseThrow();
    if (element.def().filter(tree::used).isPresent()) {
      throw new EditRejectedException(
          ("%s: the metadata '%s' is also used elsewhere (USE), so a change "
                      + "here would change it")
                  .formatted(document.location(element.start()), element.def().get())
              + " there; give each node its own metadata in the source view first");
    }
  }
}
