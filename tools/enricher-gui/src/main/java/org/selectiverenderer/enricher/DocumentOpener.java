package org.selectiverenderer.enricher;

import java.awt.EventQueue;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * Opens documents in place of the open one; reads them in the background. For the event dispatch
 * thread.
 */
final class DocumentOpener {
  /**
   * The callbacks to the window that a document is opened in.
   *
   * @param bench the views of the open document; empty for none
   * @param saves asks about unsaved changes before the open document is replaced
   * @param adopt shows the document that was read
   * @param elsewhere brings another window to the front that has a file; false if none has it
   * @param announce shows what is being read; an empty text when reading has ended
   * @param say shows a message in the status bar
   */
  record Place(
      Supplier<Optional<Workbench>> bench,
      SaveCommands saves,
      Consumer<DocumentFile> adopt,
      Predicate<Path> elsewhere,
      Consumer<String> announce,
      Consumer<String> say) {}

  /** The scene that was asked for last, and what to run when it is open. */
  private record Awaited(Path path, Runnable opened) {}

  private final Place place;
  private final TaskExecutor tasks;
  private final UserPrompts questions;
  private final CrashRecovery recovery;
  private final CrashRecoveryPrompt kept;
  private final ConversionPrompt conversion;
  private @Nullable Awaited awaited;

  DocumentOpener(
      Place place,
      NodeCatalogue catalogue,
      TaskExecutor tasks,
      UserPrompts questions,
      CrashRecovery recovery) {
    this.place = place;
    this.tasks = tasks;
    this.questions = questions;
    this.recovery = recovery;
    conversion = new ConversionPrompt(catalogue, tasks, questions, this::read, place.say());
    kept = new CrashRecoveryPrompt(recovery, questions, place.say());
  }

  /** Starts with a scene, after asking what to do with the unsaved changes of a crashed session. */
  void begin(Optional<Path> scene) {
    Optional<UserPrompts.Left> answer = kept.offer(this::restore);
    if (!answer.equals(Optional.of(UserPrompts.Left.RESTORE))) {
      scene.ifPresent(path -> open(path, () -> {}));
    }
  }

  /** Asks again what to do with the unsaved changes of crashed sessions. */
  void askAboutKept() {
    if (kept.offer(this::restore).isEmpty()) {
      questions.tell(Texts.of("window.nokept"));
    }
  }

  private void restore(CrashRecovery.RecoveryCopy left) {
    place
        .saves()
        .leaving(
            () ->
                load(
                    Texts.of("window.restoring", left.file().getFileName()),
                    () -> recovery.open(left)));
  }

  void chooseAndOpen() {
    questions
        .fileToOpen(place.bench().get().map(bench -> bench.session().file().path()))
        .ifPresent(path -> open(path, () -> {}));
  }

  /**
   * Opens a scene in place of the open one, which the author may save first.
   *
   * @param opened runs when the scene is open
   */
  void open(Path path, Runnable opened) {
    if (place.elsewhere().test(path)) {
      place.say().accept(Texts.of("window.elsewhere", String.valueOf(path.getFileName())));
      return;
    }
    awaited = new Awaited(path, opened);
    place
        .saves()
        .leaving(
            () -> {
              place.announce().accept(Texts.of("window.opening", path.getFileName()));
              conversion.open(path, () -> read(path), this::nothing);
            });
  }

  /** Opens a scene in place of the open one, about whose changes the author has been asked. */
  void openUnasked(Path path) {
    awaited = new Awaited(path, () -> {});
    read(path);
  }

  /** Returns whether a file is being read, to be shown. */
  boolean reading(Path absolute) {
    return awaited != null && awaited.path().toAbsolutePath().normalize().equals(absolute);
  }

  /** Runs what waits for this document, which is open now. */
  void opened(Path path) {
    place.announce().accept("");
    if (awaited != null && awaited.path().equals(path)) {
      awaited.opened().run();
      awaited = null;
    }
  }

  /** Opens the file in which a problem is, such as an inlined one, in place of the scene. */
  void openElsewhere(SourceLocation where) {
    Path other = Path.of(where.file());
    if (Files.isRegularFile(other)) {
      open(other, () -> {});
    } else {
      place.say().accept(Texts.of("problems.no.file", where.file()));
    }
  }

  /** Reads the open document again from its file. */
  void reload(Path path) {
    load(Texts.of("window.reloading", path.getFileName()), () -> DocumentFile.open(path));
  }

  private void read(Path path) {
    load(Texts.of("window.opening", path.getFileName()), () -> DocumentFile.open(path));
  }

  private void load(String name, Callable<DocumentFile> opening) {
    place.announce().accept(name);
    Optional<Workbench> before = place.bench().get();
    long agreed = revision(before);
    BackgroundTask task =
        tasks.run(
            name,
            opening,
            file -> {
              if (before.isPresent()
                  && before.equals(place.bench().get())
                  && revision(before) != agreed) {
                // The author has edited the open document while the other one was read.
                place.saves().leaving(() -> place.adopt().accept(file));
              } else {
                place.adopt().accept(file);
              }
            },
            failed -> {
              nothing();
              questions.tell(String.valueOf(failed.getMessage()));
            });
    task.onCancel(() -> EventQueue.invokeLater(this::nothing));
  }

  private void nothing() {
    awaited = null;
    place.announce().accept("");
  }

  private static long revision(Optional<Workbench> bench) {
    return bench.map(open -> open.session().document().revision()).orElse(0L);
  }
}
