package org.selectiverenderer.app.start.window;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import javax.swing.SwingUtilities;
import org.selectiverenderer.app.process.CommandProcess;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.app.start.StartCommands;
import org.selectiverenderer.swing.BackgroundReader;

/** Starts commands, and shows what they say where they fail. For Swing's event thread. */
final class Launcher {
  /** Most lines of a command that are kept. */
  private static final int MOST = 40;

  private final BackgroundReader reader;
  private final RecentPaths scenes;
  private final Consumer<String> say;
  private int starts;

  /**
   * @param scenes the list of the scenes that were shown
   * @param say shows a sentence to the user; empty takes away the one before
   */
  Launcher(BackgroundReader reader, RecentPaths scenes, Consumer<String> say) {
    this.reader = reader;
    this.scenes = scenes;
    this.say = say;
  }

  /** Shows a scene in the viewer, and remembers it. */
  void show(Path scene) {
    start(StartCommands.show(scene), StartTexts.of("opening", String.valueOf(scene.getFileName())));
    reader.read(
        () -> {
          scenes.add(scene);
          return scene;
        },
        added -> {},
        say);
  }

  /**
   * Starts a command whose lines are shown only if it fails.
   *
   * @param opening says that it starts
   */
  void start(ProgramCommand command, String opening) {
    say.accept(opening);
    int number = ++starts;
    Deque<String> told = new ArrayDeque<>();
    start(
        command,
        line -> {
          told.addLast(line);
          if (told.size() > MOST) {
            told.removeFirst();
          }
        },
        status -> {
          if (status != 0) {
            say.accept(
                told.isEmpty()
                    ? StartTexts.of("failed", Integer.toString(status))
                    : String.join("\n", told));
          } else if (number == starts) {
            say.accept("");
          }
        });
  }

  /**
   * Starts a command; says why where it cannot be started.
   *
   * @param lines receives its output, on Swing's event thread
   * @param ended receives its exit status, on that thread
   */
  void start(ProgramCommand command, Consumer<String> lines, IntConsumer ended) {
    reader.read(
        () ->
            CommandProcess.start(
                command,
                line -> SwingUtilities.invokeLater(() -> lines.accept(line)),
                status -> SwingUtilities.invokeLater(() -> ended.accept(status))),
        process -> {},
        say);
  }
}
