package org.selectiverenderer.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.x3d.source.TextChange;

/**
 * A named change of a document, one step to undo.
 *
 * @param name what the author did, as a menu shows it: {@code Set schemas of Switch_TrashCan}
 * @param changes in order of their places, which do not overlap; offsets are those before the edit
 */
public record Edit(String name, List<TextChange> changes) {
  public Edit {
    List<TextChange> sorted = new ArrayList<>(changes);
    sorted.sort(Comparator.comparingInt(TextChange::from).thenComparingInt(TextChange::to));
    for (int i = 1; i < sorted.size(); i++) {
      if (sorted.get(i).from() < sorted.get(i - 1).to()) {
        throw new IllegalArgumentException(
            "the changes " + sorted.get(i - 1) + " and " + sorted.get(i) + " overlap");
      }
    }
    changes = List.copyOf(sorted);
  }

  /** Whether nothing would change. */
  public boolean isEmpty() {
    return changes.isEmpty();
  }
}
