package org.selectiverenderer.authoring;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A named change of a document, which is one undo step.
 *
 * @param name the name of the change for the Undo menu: {@code Set schemas of Switch_TrashCan}
 * @param changes non-overlapping text changes in ascending order; offsets are those before the edit
 */
public record Edit(String name, List<TextEdit> changes) {
  public Edit {
    List<TextEdit> sorted = new ArrayList<>(changes);
    sorted.sort(Comparator.comparingInt(TextEdit::from).thenComparingInt(TextEdit::to));
    for (int i = 1; i < sorted.size(); i++) {
      if (sorted.get(i).from() < sorted.get(i - 1).to()) {
        throw new IllegalArgumentException(
            "the changes " + sorted.get(i - 1) + " and " + sorted.get(i) + " overlap");
      }
    }
    changes = List.copyOf(sorted);
  }

  /** Returns where a character is after the edit that was at an offset before, if it stays. */
  public int moved(int offset) {
    int at = offset;
    for (TextEdit change : changes) {
      if (change.to() <= offset) {
        at += change.text().length() - (change.to() - change.from());
      }
    }
    return at;
  }

  /** Returns whether the edit changes nothing. */
  public boolean isEmpty() {
    return changes.isEmpty();
  }
}
