package org.selectiverenderer.enricher.session;

import java.awt.EventQueue;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.UndoListener;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Remembers which nodes were selected before and after the steps of the history, and selects them
 * again when a step is undone or redone. It keeps their paths, no elements, for a bounded number of
 * nodes and steps; what is typed is not remembered, as the caret stays where it is.
 */
final class SelectionHistory implements UndoListener {
  private static final int MOST_STEPS = 500;
  private static final int MOST_NODES = 100;

  /** Holds what was selected around a step. */
  private static final class Around {
    private final List<ElementPath> before;
    private @Nullable List<ElementPath> after;

    Around(List<ElementPath> before) {
      this.before = before;
    }
  }

  private final Map<Long, Around> steps = new LinkedHashMap<>();
  private final Supplier<List<DocumentElement>> selected;
  private final Consumer<List<ElementPath>> select;

  /** The step whose selection afterwards is not yet known. */
  private @Nullable Around latest;

  /**
   * @param selected returns the selected elements
   * @param select selects the elements of paths
   */
  SelectionHistory(Supplier<List<DocumentElement>> selected, Consumer<List<ElementPath>> select) {
    this.selected = selected;
    this.select = select;
  }

  @Override
  public void begins(Move move, long step) {
    settle(latest);
    if (move == Move.MAKE) {
      steps.put(step, new Around(paths()));
      if (steps.size() > MOST_STEPS) {
        steps.remove(steps.keySet().iterator().next());
      }
    }
  }

  @Override
  public void ended(Move move, long step) {
    Optional<Around> around = Optional.ofNullable(steps.get(step));
    switch (move) {
      case MAKE -> around.ifPresent(this::follow);
      case UNDO -> around.map(each -> each.before).ifPresent(this::restore);
      case REDO -> around.map(each -> each.after).ifPresent(this::restore);
    }
  }

  /** A command selects what it has made before it ends; what the author selects comes later. */
  private void follow(Around made) {
    latest = made;
    if (EventQueue.isDispatchThread()) {
      EventQueue.invokeLater(() -> settle(made));
    }
  }

  private void settle(@Nullable Around of) {
    if (of != null && of == latest) {
      of.after = paths();
      latest = null;
    }
  }

  private void restore(List<ElementPath> paths) {
    if (!paths.isEmpty()) {
      select.accept(paths);
    }
  }

  private List<ElementPath> paths() {
    List<DocumentElement> now = selected.get();
    return now.size() > MOST_NODES ? List.of() : now.stream().map(ElementPath::of).toList();
  }
}
