package org.selectiverenderer.app.studies.window;

import java.awt.Desktop;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.process.CommandProcess;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.app.studies.StudyCommands;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.swing.BackgroundReader;

/**
 * The open study, its commands, and the studies opened lately. Belongs to Swing's event thread, on
 * which its listeners are called; it reads files by a {@link BackgroundReader}.
 */
final class StudyDesk {
  /** Name of the study file in a study's folder. */
  static final String STUDY = "study.json";

  private final RecentPaths recent;
  private final BackgroundReader reader;
  private final Predicate<Study> trusted;
  private final List<Consumer<Optional<StudyOverview>>> listeners = new ArrayList<>();
  private final Consumer<String> say;
  private @Nullable StudyOverview open;
  private boolean reading;
  private boolean readAgain;

  /**
   * @param trusted asks the user, on the reader's thread, whether a study may have what it asks for
   * @param say shows a sentence to the user; empty takes away the one before
   */
  StudyDesk(
      RecentPaths recent, BackgroundReader reader, Predicate<Study> trusted, Consumer<String> say) {
    this.recent = recent;
    this.reader = reader;
    this.trusted = trusted;
    this.say = say;
  }

  /** Has a listener called when a study is opened, read again, or closed (empty). */
  void listen(Consumer<Optional<StudyOverview>> hears) {
    listeners.add(hears);
  }

  Optional<StudyOverview> study() {
    return Optional.ofNullable(open);
  }

  /** Returns the commands of the open study. */
  Optional<StudyCommands> commands() {
    return study().map(known -> new StudyCommands(known.study().file()));
  }

  BackgroundReader reader() {
    return reader;
  }

  void say(String sentence) {
    say.accept(sentence);
  }

  /** Lists the studies opened lately, on the reader's thread. */
  void recent(Consumer<List<Path>> then) {
    reader.read(recent::list, then, say);
  }

  /** Takes a study from the list of those opened lately. */
  void forget(Path study, Runnable then) {
    reader.read(
        () -> {
          recent.remove(study);
          return study;
        },
        removed -> then.run(),
        say);
  }

  /** Opens a study by its file or folder; says why where it cannot. */
  void open(Path place) {
    say(StudyTexts.of("opening", place.toString()));
    Callable<Opened> work =
        () -> {
          Path file =
              (Files.isDirectory(place) ? place.resolve(STUDY) : place)
                  .toAbsolutePath()
                  .normalize();
          ProblemCollector problems = new ProblemCollector();
          Optional<StudyOverview> found = StudyOverview.read(file, trusted, problems);
          if (found.isPresent()) {
            recent.add(file);
          }
          return new Opened(file, found, problems.list());
        };
    reader.read(work, this::opened, say);
  }

  private record Opened(Path file, Optional<StudyOverview> study, List<Problem> problems) {}

  private void opened(Opened opened) {
    if (opened.study().isEmpty()) {
      say(
          StudyTexts.of("opening.failed", opened.file().toString())
              + "\n"
              + opened.problems().stream()
                  .map(Problem::toString)
                  .collect(Collectors.joining("\n")));
      return;
    }
    say("");
    show(opened.study().get());
  }

  private void show(StudyOverview overview) {
    open = overview;
    tell();
  }

  private void tell() {
    listeners.forEach(each -> each.accept(study()));
  }

  /** Closes the study; its sessions go on. */
  void close() {
    open = null;
    say("");
    tell();
  }

  /**
   * Reads the sessions of the study again; one call at a time, and once more if asked meanwhile.
   */
  void reload() {
    StudyOverview before = open;
    if (before == null) {
      return;
    }
    if (reading) {
      readAgain = true;
      return;
    }
    reading = true;
    reader.read(
        before::again,
        after -> {
          boolean more = readAgain;
          reading = false;
          readAgain = false;
          if (open == before) {
            show(after);
          }
          if (more) {
            reload();
          }
        },
        why -> {
          reading = false;
          readAgain = false;
          say(why);
        });
  }

  /**
   * Starts a command; says why where it cannot be started.
   *
   * @param lines receives its output, on Swing's event thread
   * @param ended receives its exit status, on that thread
   * @param started receives the process once it runs
   */
  void start(
      ProgramCommand command,
      Consumer<String> lines,
      IntConsumer ended,
      Consumer<CommandProcess> started) {
    say("");
    reader.read(
        () ->
            CommandProcess.start(
                command,
                line -> SwingUtilities.invokeLater(() -> lines.accept(line)),
                status -> SwingUtilities.invokeLater(() -> ended.accept(status))),
        started,
        why -> {
          say(why);
          ended.accept(-1);
        });
  }

  /**
   * Runs a command whose messages are shown only if it fails.
   *
   * @param done called when it has succeeded
   * @param failed called when it has not, after its messages are shown
   */
  void run(ProgramCommand command, Runnable done, Runnable failed) {
    List<String> told = new ArrayList<>();
    start(
        command,
        told::add,
        status -> {
          if (status == 0) {
            done.run();
          } else {
            say(
                told.isEmpty()
                    ? StudyTexts.of("command.failed", Integer.toString(status))
                    : String.join("\n", told));
            failed.run();
          }
        },
        process -> {});
  }

  /** Opens a page by the desktop's browser; says where it is where that cannot be. */
  void browse(Path page) {
    reader.read(
        () -> {
          if (!Desktop.isDesktopSupported()
              || !Desktop.getDesktop().isSupported(Desktop.Action.BROWSE)) {
            throw new IOException(StudyTexts.of("browse.none", page.toString()));
          }
          Desktop.getDesktop().browse(page.toUri());
          return page;
        },
        shown -> {},
        say);
  }
}
