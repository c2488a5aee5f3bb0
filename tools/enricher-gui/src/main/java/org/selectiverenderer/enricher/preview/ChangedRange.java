package org.selectiverenderer.enricher.preview;

import java.util.List;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The range of a text that one or several changes in succession have touched; all before and behind
 * it is the same. A value.
 *
 * @param from offset of its beginning, before and after
 * @param to offset of its end, after
 * @param growth by how many characters the text has grown
 */
record ChangedRange(int from, int to, int growth) {
  /** Returns the range of one change of a document. */
  static ChangedRange of(DocumentListener.Change change) {
    List<TextEdit> edits = change.changes();
    int growth = edits.stream().mapToInt(TextEdit::growth).sum();
    int from = edits.get(0).from();
    return new ChangedRange(from, edits.get(edits.size() - 1).to() + growth, growth);
  }

  /** Returns the range that this one and a later change have touched together. */
  ChangedRange and(ChangedRange later) {
    int before = Math.max(to, later.to - later.growth);
    return new ChangedRange(
        Math.min(from, later.from), before + later.growth, growth + later.growth);
  }
}
