package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** An edit that puts elements into a document, and which they are once it is performed. */
public final class StructureChange {
  private final Edit edit;
  private final List<Added> added;

  /**
   * @param change the insertion, one of the edit's changes
   * @param count number of elements that it inserts
   */
  record Added(TextEdit change, int count) {}

  StructureChange(Edit edit, List<Added> added) {
    this.edit = edit;
    this.added = List.copyOf(added);
  }

  /** Returns the edit, which is empty if nothing would change. */
  public Edit edit() {
    return edit;
  }

  /**
   * Returns the elements that the edit has put into a document.
   *
   * @param document the document, on which the edit was the last one performed
   */
  public List<DocumentElement> elements(SceneDocument document) {
    List<DocumentElement> found = new ArrayList<>();
    document
        .tree()
        .ifPresent(
            tree -> {
              for (Added each : added) {
                tree.at(place(each.change()))
                    .ifPresent(first -> found.addAll(siblings(first, each.count())));
              }
            });
    return found;
  }

  private static List<DocumentElement> siblings(DocumentElement first, int count) {
    return first
        .parent()
        .map(DocumentElement::children)
        .map(
            all -> {
              int from = all.indexOf(first);
              return List.copyOf(all.subList(from, Math.min(all.size(), from + count)));
            })
        .orElse(List.of());
  }

  /** Returns the offset of the first inserted element after the edit. */
  private int place(TextEdit insertion) {
    int at = insertion.from() + insertion.text().indexOf('<');
    for (TextEdit change : edit.changes()) {
      if (change.equals(insertion)) {
        break;
      }
      at += change.text().length() - (change.to() - change.from());
    }
    return at;
  }
}
