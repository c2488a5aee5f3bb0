package org.selectiverenderer.enricher.cost;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskProgress;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.polygon.IncrementalSceneCounter;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.ValidationSettings;

/**
 * Counts the polygons of the document's present state, saved or not, after every pause in editing.
 * For the event dispatch thread; counts in a background task of the session.
 */
final class CostUpdater {
  /** Milliseconds without an edit before the scene is counted again. */
  private static final int PAUSE = 500;

  /**
   * The result of a count.
   *
   * @param rows empty if nothing was counted, as the panel is hidden and no limit is set
   * @param fault why the settings file is not usable; empty if it is
   */
  record Found(Optional<List<CostRow>> rows, Optional<String> fault) {}

  private final EnricherSession session;
  private final BudgetFileLocator place;
  private final Consumer<Found> listener;
  private final IncrementalSceneCounter counter = new IncrementalSceneCounter();

  /**
   * Lets one task count at a time; a task that is cancelled while it waits frees its thread at
   * once.
   */
  private final Lock turn = new ReentrantLock();

  private final DocumentListener onChange = change -> changed();
  private final Timer pause = new Timer(PAUSE, event -> now());
  private boolean seen;
  private boolean stale = true;
  private @Nullable BackgroundTask task;

  CostUpdater(EnricherSession session, BudgetFileLocator place, Consumer<Found> listener) {
    this.session = session;
    this.place = place;
    this.listener = listener;
    pause.setRepeats(false);
    session.document().addListener(onChange);
  }

  private void changed() {
    stale = true;
    cancel();
    pause.restart();
  }

  /** Sets whether the panel is visible. */
  void seen(boolean now) {
    seen = now;
    if (seen && stale && task == null) {
      now();
    }
  }

  /**
   * Forgets the files that the scene names, which may have changed without a new time stamp, and
   * counts again.
   */
  void forget() {
    counter.forget();
    now();
  }

  /** Whether a count is under way. */
  boolean counting() {
    return task != null;
  }

  /** Counts without waiting for a pause. */
  void now() {
    cancel();
    if (session.document().tree().isEmpty()) {
      return; // While the text is not well formed, the last count stays.
    }
    DocumentSnapshot snapshot = session.document().snapshot();
    Path file = session.file().path().toAbsolutePath();
    boolean wanted = seen;
    task =
        session
            .tasks()
            .run(
                Texts.of("cost.counting"),
                progress -> count(snapshot, file, wanted, progress),
                this::found,
                this::failed);
  }

  private Found count(DocumentSnapshot snapshot, Path file, boolean wanted, TaskProgress progress)
      throws IOException, InterruptedException {
    ProblemCollector problems = new ProblemCollector();
    Optional<ValidationSettings> settings = place.settings(problems);
    Optional<String> fault = problems.list().stream().map(Problem::toString).findFirst();
    List<CostBudget> budgets = settings.map(s -> s.budgets(file)).orElse(List.of());
    if (!wanted && budgets.isEmpty()) {
      return new Found(Optional.empty(), fault);
    }
    turn.lockInterruptibly();
    try {
      progress.check();
      IncrementalSceneCounter.CountResult counted =
          counter.count(
              file,
              snapshot.name(),
              snapshot.bytes(),
              settings.map(s -> s.access().and(session.access())).orElse(session.access()));
      progress.check();
      return new Found(Optional.of(CostRow.of(counted, budgets)), fault);
    } finally {
      turn.unlock();
    }
  }

  private void found(Found found) {
    task = null;
    stale = found.rows().isEmpty();
    listener.accept(found);
    if (stale && seen) {
      now();
    }
  }

  private void failed(Exception e) {
    task = null;
    Throwable cause = e instanceof ExecutionException && e.getCause() != null ? e.getCause() : e;
    String why = cause.getMessage() == null ? cause.toString() : cause.getMessage();
    listener.accept(new Found(Optional.empty(), Optional.of(Texts.of("cost.failed", why))));
  }

  private void cancel() {
    if (task != null) {
      task.cancel();
      task = null;
    }
  }

  void dispose() {
    pause.stop();
    cancel();
    session.document().removeListener(onChange);
  }
}
