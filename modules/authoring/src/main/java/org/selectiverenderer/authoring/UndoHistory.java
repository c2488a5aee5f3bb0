package org.selectiverenderer.authoring;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.stream.Stream;
import org.selectiverenderer.x3d.source.TextEdit;

/** The undo and redo steps of a document. */
public final class UndoHistory {
  /** An undo step; it is a list of sets of changes, each in the offsets after the previous set. */
  private record Step(
      long number,
      String name,
      List<List<TextEdit>> undo,
      Optional<UndoableFileWrites> files,
      long characters) {
    Step(long number, String name, List<List<TextEdit>> undo, Optional<UndoableFileWrites> files) {
      this(
          number,
          name,
          undo,
          files,
          undo.stream()
              .flatMap(List::stream)
              .mapToLong(edit -> PER_EDIT + edit.text().length())
              .sum());
    }
  }

  /** Counts what an edit takes beside its text, in characters. */
  private static final int PER_EDIT = 64;

  /**
   * The largest memory for contents of files; older steps beyond it leave their files as they are.
   */
  private static final long MOST_KEPT = 256L << 20;

  /** Most characters that steps hold; the oldest steps beyond are forgotten, but never the last. */
  private static final long MOST_CHARACTERS = 128L << 20;

  private final Function<List<TextEdit>, List<TextEdit>> text;
  private final List<Step> done = new ArrayList<>();
  private final List<Step> undone = new ArrayList<>();
  private final long most;
  private final List<UndoListener> listeners = new CopyOnWriteArrayList<>();
  private long numbers;
  private int saved;
  private boolean typing;

  /**
   * @param text applies changes and returns their inverse
   */
  UndoHistory(Function<List<TextEdit>, List<TextEdit>> text) {
    this(text, MOST_CHARACTERS);
  }

  /**
   * @param text applies changes and returns their inverse
   * @param most the most characters that the steps may hold
   */
  UndoHistory(Function<List<TextEdit>, List<TextEdit>> text, long most) {
    this.text = text;
    this.most = most;
  }

  /** Performs an edit; one that changes nothing is not a step. */
  void perform(Edit edit) {
    if (!edit.isEmpty()) {
      make(edit, Optional.empty());
    }
  }

  /** Performs an edit whose files have been written; they belong to its step. */
  void perform(Edit edit, UndoableFileWrites files) {
    make(edit, Optional.of(files));
    forgetFiles();
  }

  private void make(Edit edit, Optional<UndoableFileWrites> files) {
    long number = ++numbers;
    listeners.forEach(listener -> listener.begins(UndoListener.Move.MAKE, number));
    push(new Step(number, edit.name(), List.of(text.apply(edit.changes())), files));
    typing = false;
    listeners.forEach(listener -> listener.ended(UndoListener.Move.MAKE, number));
  }

  public void addListener(UndoListener listener) {
    listeners.add(listener);
  }

  public void removeListener(UndoListener listener) {
    listeners.remove(listener);
  }

  private void forgetFiles() {
    long kept = 0;
    for (int i = done.size() - 1; i >= 0; i--) {
      Step step = done.get(i);
      kept += step.files().map(UndoableFileWrites::size).orElse(0L);
      if (step.files().isPresent() && kept > MOST_KEPT) {
        done.set(
            i,
            new Step(
                step.number(), step.name() + " (its files stay)", step.undo(), Optional.empty()));
      }
    }
  }

  /** Performs a change by typing, which is merged with a previous one. */
  void type(String name, TextEdit change) {
    List<TextEdit> inverse = text.apply(List.of(change));
    if (typing()) {
      Step step = done.remove(done.size() - 1);
      List<List<TextEdit>> undo = new ArrayList<>(List.of(inverse));
      undo.addAll(step.undo());
      done.add(new Step(step.number(), step.name(), undo, step.files()));
      forget(true);
    } else {
      push(new Step(++numbers, name, List.of(inverse), Optional.empty()));
    }
    typing = true;
  }

  /** Returns whether the next typing is merged with the last step. */
  public boolean typing() {
    return typing && saved != done.size() && undone.isEmpty();
  }

  /** Makes the next typing a separate step, because the author has paused or moved the caret. */
  public void endTyping() {
    typing = false;
  }

  private void push(Step step) {
    if (saved > done.size()) {
      saved = -1; // what was saved can be reached no more
    }
    undone.clear();
    done.add(step);
    forget(true);
  }

  /**
   * Forgets the steps farthest from the present beyond the memory that steps may take, but never
   * the nearest ones.
   *
   * @param doneFirst whether steps that are done are forgotten before those that are undone
   */
  private void forget(boolean doneFirst) {
    long held = characters();
    for (boolean ofDone : new boolean[] {doneFirst, !doneFirst}) {
      List<Step> steps = ofDone ? done : undone;
      int gone = 0;
      while (held > most && gone < steps.size() - 1) {
        held -= steps.get(gone++).characters();
      }
      steps.subList(0, gone).clear();
      if (ofDone) {
        saved = saved < gone ? -1 : saved - gone;
      }
    }
    if (saved > done.size() + undone.size()) {
      saved = -1; // what was saved can be reached no more
    }
  }

  /**
   * Returns how many characters all steps hold: those that their edits have replaced, not the text,
   * and 64 for each edit.
   */
  public long characters() {
    return Stream.concat(done.stream(), undone.stream()).mapToLong(Step::characters).sum();
  }

  /** Returns the number of the step that {@link #undo()} reverts, see {@link UndoListener}. */
  public OptionalLong last() {
    return done.isEmpty()
        ? OptionalLong.empty()
        : OptionalLong.of(done.get(done.size() - 1).number());
  }

  /** Returns the name of the step that {@link #undo()} reverts. */
  public Optional<String> undoName() {
    return done.isEmpty() ? Optional.empty() : Optional.of(done.get(done.size() - 1).name());
  }

  /** Returns the name of the step that {@link #redo()} repeats. */
  public Optional<String> redoName() {
    return undone.isEmpty() ? Optional.empty() : Optional.of(undone.get(undone.size() - 1).name());
  }

  /** Returns the names of all steps that can be undone, the oldest first. */
  public List<String> names() {
    return done.stream().map(Step::name).toList();
  }

  /**
   * Reverts the last step including its files; returns false if there is none.
   *
   * @throws EditRejectedException if a file cannot be restored or another program has changed it;
   *     then nothing is reverted
   */
  public boolean undo() {
    return undo(false);
  }

  /**
   * Reverts the last step including its files; returns false if there is none.
   *
   * @param over whether files that another program has changed are replaced
   */
  public boolean undo(boolean over) {
    return move(done, undone, true, over);
  }

  /**
   * Repeats the last step that was reverted; returns false if there is none.
   *
   * @throws EditRejectedException as {@link #undo()} does
   */
  public boolean redo() {
    return redo(false);
  }

  /**
   * Repeats the last step that was reverted; returns false if there is none.
   *
   * @param over whether files that another program has changed are replaced
   */
  public boolean redo(boolean over) {
    return move(undone, done, false, over);
  }

  /** Returns whether undoing or redoing writes or removes files beside the document's own. */
  public boolean concernsFiles(boolean back) {
    List<Step> steps = back ? done : undone;
    return !steps.isEmpty() && steps.get(steps.size() - 1).files().isPresent();
  }

  /**
   * Returns the files that undoing or redoing would replace although another program has changed
   * them.
   *
   * @throws EditRejectedException if one cannot be read
   */
  public List<Path> changedMeanwhile(boolean back) {
    List<Step> steps = back ? done : undone;
    if (!concernsFiles(back)) {
      return List.of();
    }
    try {
      return steps.get(steps.size() - 1).files().get().changedMeanwhile(back);
    } catch (IOException e) {
      throw new EditRejectedException(String.valueOf(e.getMessage()));
    }
  }

  private boolean move(List<Step> from, List<Step> to, boolean back, boolean over) {
    typing = false;
    if (from.isEmpty()) {
      return false;
    }
    Step step = from.get(from.size() - 1);
    if (step.files().isPresent()) {
      try {
        step.files().get().move(back, over);
      } catch (IOException e) {
        throw new EditRejectedException(String.valueOf(e.getMessage()));
      }
    }
    UndoListener.Move way = back ? UndoListener.Move.UNDO : UndoListener.Move.REDO;
    listeners.forEach(listener -> listener.begins(way, step.number()));
    from.remove(from.size() - 1);
    List<List<TextEdit>> inverse = new ArrayList<>();
    for (List<TextEdit> part : step.undo()) {
      inverse.add(0, text.apply(part));
    }
    to.add(new Step(step.number(), step.name(), inverse, step.files()));
    forget(!back);
    listeners.forEach(listener -> listener.ended(way, step.number()));
    return true;
  }

  /** Returns whether the text differs from what was saved or opened. */
  public boolean modified() {
    return saved != done.size();
  }

  void markSaved() {
    saved = done.size();
    typing = false;
  }

  /** Marks the text as never saved, for example after a recovery. */
  void markUnsaved() {
    saved = -1;
  }
}
