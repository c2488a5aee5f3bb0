package org.selectiverenderer.authoring.enrichment;

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
   * @throws EditRejectedException if the element or a descendant is referenced by USE
   */
  void free(DocumentElement element) {
    ElementTree tree = document.tree().orElseThrow();
    element.visit(
        each -> {
          if (each.def().filter(tree::used).isPresent()) {
            throw new EditRejectedException(
                ("%s: the metadata '%s' is also used elsewhere (USE), so a change "
                            + "here would change it")
                        .formatted(document.location(each.start()), each.def().get())
                    + " there; give each node its own metadata in the source view first");
          }
        });
  }
}
