package org.selectiverenderer.enricher.versions;

import java.util.function.Consumer;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/**
 * Computes versions in the background, one request after the other: while a slider is dragged, only
 * the newest request is computed when the previous one is ready. Cancelling drops the request being
 * computed.
 */
final class VersionsUpdater {
  private static final String FOLDER = "inlineNodes";
  private static final int SETTLED = 150; // milliseconds without a change

  private final EnricherSession session;
  private final VersionsModel model;
  private final Consumer<String> failed;
  private final Timer settle = new Timer(SETTLED, e -> start());
  private long running;
  private @Nullable BackgroundTask task;
  private long cancelled;
  private boolean closed;

  /**
   * @param failed called with a sentence if a computation fails
   */
  VersionsUpdater(EnricherSession session, VersionsModel model, Consumer<String> failed) {
    this.session = session;
    this.model = model;
    this.failed = failed;
    settle.setRepeats(false);
    model.addListener(this::changed);
  }

  private void changed() {
    if (!closed && model.wanted() > cancelled && !model.current() && running == 0) {
      settle.restart();
    }
  }

  /** Computes the present request. */
  void start() {
    if (closed || running != 0 || model.current() || model.object().isEmpty()) {
      return;
    }
    long number = model.wanted();
    running = number;
    DocumentSnapshot snapshot = session.document().snapshot();
    VersionsEdit.Request request =
        model.aimed(
            new VersionsEdit.Request(
                    session.file().path(),
                    model.object(),
                    model.goals().stream().<SimplificationTarget>map(VersionGoal::goal).toList(),
                    FOLDER)
                .allowing(session.access())
                .keeping(model.kept())
                .named(model.name()));
    boolean beginning = model.beginning();
    task =
        session
            .tasks()
            .run(
                Texts.of("versions.task", model.object()),
                () ->
                    beginning
                        ? ComputedVersions.first(snapshot, request, session.catalogue())
                        : ComputedVersions.of(snapshot, request, session.catalogue()),
                computed -> done(number, () -> model.take(number, computed)),
                failure -> done(number, () -> failed.accept(sentence(failure))));
  }

  private static String sentence(Exception failure) {
    String message = failure.getMessage();
    return message == null
        ? Texts.of("versions.failed", failure.toString())
        : Remarks.shown(message);
  }

  private void done(long number, Runnable report) {
    if (running != number) {
      return; // cancelled meanwhile
    }
    running = 0;
    if (!closed) {
      report.run();
      if (model.wanted() > number) {
        settle.restart();
      }
    }
  }

  boolean busy() {
    return running != 0 || settle.isRunning();
  }

  /** Cancels the present computation; the next change starts another one. */
  void cancel() {
    settle.stop();
    if (task != null) {
      task.cancel();
    }
    running = 0;
    cancelled = model.wanted();
  }

  /** Ends the computations, as the dialog is closed. */
  void close() {
    closed = true;
    cancel();
  }
}
