package org.selectiverenderer.authoring;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.source.LineIndex;
import org.selectiverenderer.x3d.source.TextEdit;

/** A mutable text with an index of its lines. */
final class TextBuffer {
  /**
   * The largest number of changes that are made in place; for more the text is rebuilt in one pass.
   */
  private static final int IN_PLACE = 8;

  private StringBuilder text;
  private final LineIndex lines;

  TextBuffer(String text) {
    // Spare capacity, so that the first edits do not reallocate a large text.
    this.text = new StringBuilder(text.length() + text.length() / 16 + 4096).append(text);
    this.lines = new LineIndex(text);
  }

  CharSequence characters() {
    return text;
  }

  LineIndex lines() {
    return lines;
  }

  /**
   * Applies sorted changes that do not overlap.
   *
   * @return the changes that undo them, sorted, in the offsets of the changed text
   */
  List<TextEdit> apply(List<TextEdit> changes) {
    List<TextEdit> inverse = new ArrayList<>(changes.size());
    int grown = 0;
    for (TextEdit change : changes) {
      int from = change.from() + grown;
      inverse.add(
          new TextEdit(
              from, from + change.text().length(), text.substring(change.from(), change.to())));
      grown += change.growth();
    }
    if (changes.size() <= IN_PLACE) {
      for (int i = changes.size() - 1; i >= 0; i--) {
        TextEdit change = changes.get(i);
        text.replace(change.from(), change.to(), change.text());
        lines.changed(change.from(), change.to(), change.text().length(), text);
      }
    } else {
      text = TextEdit.applied(changes, text);
      lines.reset();
    }
    return inverse;
  }
}
