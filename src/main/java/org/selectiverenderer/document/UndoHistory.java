package org.selectiverenderer.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.x3d.source.TextChange;

/** The steps that led to a document's text, and those that were undone. */
public final class UndoHistory {
  /**
   * A step; each part is a set of changes, those of later parts in the offsets after earlier ones.
   */
  private record Step(String name, List<List<TextChange>> undo) {}

  private final Function<List<TextChange>, List<TextChange>> text;
  private final List<Step> done = new ArrayList<>();
  private final List<Step> undone = new ArrayList<>();
  private int saved;
  private boolean typing;

  /**
   * @param text makes changes and returns those that undo them
   */
  UndoHistory(Function<List<TextChange>, List<TextChange>> text) {
    this.text = text;
  }

  /** Makes an edit; one that changes nothing is no step. */
  void perform(Edit edit) {
    if (!edit.isEmpty()) {
      push(edit.name(), List.of(text.apply(edit.changes())));
      typing = false;
    }
  }

  /** Makes a change by hand, which joins the one before when that was made by hand, too. */
  void type(String name, TextChange change) {
    List<TextChange> inverse = text.apply(List.of(change));
    if (typing()) {
      Step step = done.remove(done.size() - 1);
      List<List<TextChange>> undo = new ArrayList<>(List.of(inverse));
      undo.addAll(step.undo());
      done.add(new Step(step.name(), undo));
    } else {
      push(name, List.of(inverse));
    }
    typing = true;
  }

  /** Whether what is typed next joins the last step. */
  public boolean typing() {
    return typing && saved != done.size() && undone.isEmpty();
  }

  /** What is typed next is a step of its own: the author has paused, or gone elsewhere. */
  public void endTyping() {
    typing = false;
  }

  private void push(String name, List<List<TextChange>> undo) {
    if (saved > done.size()) {
      saved = -1; // what was saved can be reached no more
    }
    undone.clear();
    done.add(new Step(name, undo));
  }

  /** The name of the step that undo takes back. */
  public Optional<String> undoName() {
    return done.isEmpty() ? Optional.empty() : Optional.of(done.get(done.size() - 1).name());
  }

  /** The name of the step that redo makes again. */
  public Optional<String> redoName() {
    return undone.isEmpty() ? Optional.empty() : Optional.of(undone.get(undone.size() - 1).name());
  }

  /** The names of all steps that can be undone, the oldest first. */
  public List<String> names() {
    return done.stream().map(Step::name).toList();
  }

  /** Takes the last step back; false if there is none. */
  public boolean undo() {
    return move(done, undone);
  }

  /** Makes the last step that was taken back again; false if there is none. */
  public boolean redo() {
    return move(undone, done);
  }

  private boolean move(List<Step> from, List<Step> to) {
    typing = false;
    if (from.isEmpty()) {
      return false;
    }
    Step step = from.remove(from.size() - 1);
    List<List<TextChange>> inverse = new ArrayList<>();
    for (List<TextChange> part : step.undo()) {
      inverse.add(0, text.apply(part));
    }
    to.add(new Step(step.name(), inverse));
    return true;
  }

  /** Whether the text differs from what was saved or opened. */
  public boolean modified() {
    return saved != done.size();
  }

  void markSaved() {
    saved = done.size();
    typing = false;
  }

  /** The text is one that was never saved, such as one recovered after a crash. */
  void markUnsaved() {
    saved = -1;
  }
}
