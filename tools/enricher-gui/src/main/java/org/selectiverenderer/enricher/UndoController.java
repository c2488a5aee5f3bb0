package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.UndoHistory;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Undoes and redoes steps. Files of a step that another program has changed meanwhile are replaced
 * only if the author agrees. Has no widgets.
 */
record UndoController(UndoHistory history, UserPrompts questions) {
  /**
   * @param back true to undo, false to redo
   * @return whether anything was done
   */
  boolean go(boolean back) {
    try {
      List<Path> changed = history.changedMeanwhile(back);
      boolean over = !changed.isEmpty();
      if (over && !questions.overwrite(sentence(changed))) {
        return false;
      }
      return back ? history.undo(over) : history.redo(over);
    } catch (EditRejectedException e) {
      questions.tell(String.valueOf(e.getMessage()));
      return false;
    }
  }

  private static String sentence(List<Path> changed) {
    return Texts.of(
        "keep.step.changed",
        changed.stream()
            .map(path -> String.valueOf(path.getFileName()))
            .collect(Collectors.joining(", ")));
  }
}
