package org.selectiverenderer.authoring.versions;

import java.util.List;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.x3d.source.LineIndex;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A change of a scene's text, for display as whole lines.
 *
 * @param line line of its first character, from 1
 */
public record ChangePreview(int line, String before, String after) {
  /** Returns the changes of an edit of a text. */
  public static List<ChangePreview> of(Edit edit, String text) {
    LineIndex lines = new LineIndex(text);
    return edit.changes().stream().map(change -> of(change, text, lines)).toList();
  }

  private static ChangePreview of(TextEdit change, String text, LineIndex lines) {
    int line = lines.line(text, change.from());
    String before = text.substring(change.from(), change.to());
    String start = text.substring(lines.start(text, line), change.from());
    String indent = before.isBlank() || !start.isBlank() ? "" : start;
    return new ChangePreview(line, indent + before, indent + change.text());
  }
}
