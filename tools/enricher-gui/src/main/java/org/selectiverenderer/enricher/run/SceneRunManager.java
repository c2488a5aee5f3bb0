package org.selectiverenderer.enricher.run;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Manages the run processes of a window: any number at once, all of which end with the window. For
 * the event dispatch thread.
 */
public final class SceneRunManager {
  private static final int PATIENCE_SECONDS = 5;

  /** The exit code of a run that was walked to its end in a scene with problems. */
  private static final int PROBLEMS = 1;

  /** Starts a command by its arguments. */
  interface Starting {
    Process start(List<String> words) throws IOException;
  }

  private record Running(int number, Process process, RunInputFile scene) {}

  private final Consumer<String> messages;
  private final Consumer<String> status;
  private final Starting starting;
  private final List<Running> running = new CopyOnWriteArrayList<>();
  private int count;

  /**
   * @param messages called with each line of the runs' output
   * @param status called with a sentence when a run begins, fails or ends
   */
  public SceneRunManager(Consumer<String> messages, Consumer<String> status) {
    this(messages, status, ProcessLauncher::start);
  }

  SceneRunManager(Consumer<String> messages, Consumer<String> status, Starting starting) {
    this.messages = messages;
    this.status = status;
    this.starting = starting;
  }

  /**
   * Starts a run of a document's present state.
   *
   * @param here the preview's pose; empty while unknown
   */
  public void run(EnricherSession session, RunOptions choice, Optional<Pose> here) {
    if (session.document().fault().isPresent()) {
      status.accept(Texts.of("run.fault"));
      return;
    }
    if (choice.fromHere() && here.isEmpty()) {
      status.accept(Texts.of("run.nohere"));
      return;
    }
    Path file = session.file().path();
    DocumentSnapshot snapshot = session.document().snapshot();
    boolean saved = !session.document().modified();
    session
        .tasks()
        .runToEnd(
            Texts.of("run.task"),
            () ->
                RunInputFile.of(file, snapshot, saved, choice.fromHere() ? here : Optional.empty()),
            scene -> begin(scene, choice, file),
            failed -> status.accept(String.valueOf(failed.getMessage())));
  }

  private void begin(RunInputFile scene, RunOptions choice, Path file) {
    count++;
    int number = count;
    try {
      Running run = new Running(number, starting.start(scene.words(choice)), scene);
      running.add(run);
      Thread hearing = new Thread(() -> hear(run), "enricher-run");
      hearing.setDaemon(true);
      hearing.start();
      status.accept(
          Texts.of(
              "run.begun",
              Integer.toString(number),
              String.valueOf(file.getFileName()),
              choice.condition()));
    } catch (IOException e) {
      clear(scene);
      status.accept(Texts.of("run.failed", String.valueOf(e.getMessage())));
    }
  }

  /** Reads the output of a run until it ends; executed on a thread of its own. */
  private void hear(Running run) {
    String number = Integer.toString(run.number());
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(run.process().getInputStream(), Charset.defaultCharset()))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        String said = Texts.of("run.line", number, line);
        SwingUtilities.invokeLater(() -> messages.accept(said));
      }
      int code = run.process().waitFor();
      SwingUtilities.invokeLater(() -> ended(run, code));
    } catch (IOException e) { // The output is closed when close() ends the process.
      SwingUtilities.invokeLater(() -> ended(run, 0));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void ended(Running run, int code) {
    if (running.remove(run)) {
      clear(run.scene());
      String number = Integer.toString(run.number());
      status.accept(
          switch (code) {
            case 0 -> Texts.of("run.ended", number);
            case PROBLEMS -> Texts.of("run.endedproblems", number);
            default -> Texts.of("run.endedwith", number, Integer.toString(code));
          });
    }
  }

  private void clear(RunInputFile scene) {
    try {
      scene.clear();
    } catch (IOException e) {
      status.accept(Texts.of("run.left", scene.file().toString()));
    }
  }

  /** The number of runs that have not ended. */
  public int running() {
    return running.size();
  }

  /** Ends all runs and deletes their copies. */
  public void close() {
    for (Running run : running) {
      run.process().destroy();
    }
    for (Running run : running) {
      try {
        if (!run.process().waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
          run.process().destroyForcibly();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      clear(run.scene());
    }
    running.clear();
  }
}
