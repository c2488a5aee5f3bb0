package org.selectiverenderer.authoring.editing;

import java.util.List;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates the edit that suppresses a rule of the validator for an element and what is in it: a
 * comment {@code validate-ignore SR207} before the element, which {@code validate} reads too.
 */
public final class FindingSuppression {
  private final SceneDocument document;

  /** Suppresses findings of a document. */
  public FindingSuppression(SceneDocument document) {
    this.document = document;
  }

  /**
   * Returns the edit.
   *
   * @param rule id of the rule: {@code SR207}
   * @throws EditRejectedException if the element comes from an entity
   */
  public Edit suppress(String rule, DocumentElement element) {
    if (element.isReference()) {
      throw new EditRejectedException(
          element + " comes from an entity of the DOCTYPE; change it in the source");
    }
    String comment = "<!-- validate-ignore " + rule + ": accepted by the author -->";
    boolean ownLine = document.layout().onItsOwnLine(element);
    String between =
        ownLine
            ? document.layout().endOfLine(element) + document.layout().indentation(element)
            : "";
    return new Edit(
        "Ignore " + rule + " at " + element,
        List.of(TextEdit.insert(element.start(), comment + between)));
  }
}
