package org.selectiverenderer.enricher.problems;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentCheck;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskProgress;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Keeps the list of problems up to date: findings shortly after each change, and the results of
 * checks after a pause in editing.
 */
final class ProblemsUpdater {
  private static final int AT_ONCE_MS = 120;
  private static final int PAUSE_MS = 900;

  /** The longest pause, of a scene whose checks take as long. */
  private static final int LONGEST_PAUSE_MS = 5000;

  private final EnricherSession session;
  private final ProblemsModel model;
  private final List<DocumentCheck> checks;
  private final Runnable refreshed;
  private final Consumer<Boolean> checking;
  private final DocumentListener onChange = change -> changed();
  private final Timer atOnce = new Timer(AT_ONCE_MS, event -> refresh());
  private final Timer pause = new Timer(PAUSE_MS, event -> check());
  private @Nullable BackgroundTask task;

  /** Nanoseconds that the last checks took. */
  private long took;

  /**
   * @param refreshed runs after the model has been updated
   * @param checking called with true when checks begin or are due after a pause, and with false
   *     when they end
   */
  ProblemsUpdater(
      EnricherSession session,
      ProblemsModel model,
      List<DocumentCheck> checks,
      Runnable refreshed,
      Consumer<Boolean> checking) {
    this.session = session;
    this.model = model;
    this.checks = List.copyOf(checks);
    this.refreshed = refreshed;
    this.checking = checking;
    atOnce.setRepeats(false);
    pause.setRepeats(false);
    session.document().addListener(onChange);
  }

  void begin() {
    refresh();
    check();
  }

  private void changed() {
    atOnce.restart();
    pause.setInitialDelay(pauseMs(took));
    pause.restart();
    cancel();
    checking.accept(possible());
  }

  /**
   * Returns the milliseconds without an edit before checks begin: the longer, the longer they take,
   * so that they do not begin between any two edits of a large scene only to be cancelled.
   *
   * @param took nanoseconds that the last checks took
   */
  static int pauseMs(long took) {
    long same = TimeUnit.NANOSECONDS.toMillis(took);
    return (int) Math.max(PAUSE_MS, Math.min(same, LONGEST_PAUSE_MS));
  }

  /** Whether there is anything to check: a text that is not well formed has only its fault. */
  private boolean possible() {
    return !checks.isEmpty() && session.document().tree().isPresent();
  }

  private void refresh() {
    model.refresh();
    refreshed.run();
  }

  /** Runs the checks without waiting for a pause. */
  void check() {
    cancel();
    if (!possible()) {
      checking.accept(false);
      return;
    }
    DocumentSnapshot snapshot = session.document().snapshot();
    checking.accept(true);
    long begun = System.nanoTime();
    task =
        session
            .tasks()
            .run(
                Texts.of("problems.task"),
                progress -> run(snapshot, progress),
                problems -> {
                  took = System.nanoTime() - begun;
                  checked(snapshot.revision(), problems);
                },
                this::failed);
  }

  private List<Problem> run(DocumentSnapshot snapshot, TaskProgress progress) {
    List<Problem> problems = new ArrayList<>();
    for (int i = 0; i < checks.size(); i++) {
      progress.check();
      problems.addAll(checks.get(i).check(snapshot));
      progress.done((i + 1) / (double) checks.size());
    }
    return problems;
  }

  private void checked(long revision, List<Problem> problems) {
    task = null;
    checking.accept(false);
    model.checked(revision, problems);
    refresh();
  }

  private void failed(Exception e) {
    task = null;
    checking.accept(false);
    Throwable cause = e instanceof ExecutionException && e.getCause() != null ? e.getCause() : e;
    session.message(Texts.of("problems.failed", String.valueOf(cause)));
  }

  private void cancel() {
    if (task != null) {
      task.cancel();
      task = null;
    }
  }

  void dispose() {
    atOnce.stop();
    pause.stop();
    cancel();
    session.document().removeListener(onChange);
  }
}
