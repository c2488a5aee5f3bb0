package org.selectiverenderer.enricher;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.document.file.Recovery;
import org.selectiverenderer.enricher.task.Tasks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * Reads documents in the background, in place of the one that is open. For the event dispatch
 * thread.
 */
final class DocumentOpening {
  /**
   * The window that a document is opened in.
   *
   * @param bench with the document that is open
   * @param saves asks before that one goes
   * @param adopt takes over what was read
   * @param announce says what is going on; an empty text for nothing
   * @param say says something in the status bar
   */
  record Place(
      Supplier<Optional<Workbench>> bench,
      SaveCommands saves,
      Consumer<DocumentFile> adopt,
      Consumer<String> announce,
      Consumer<String> say) {}

  /** The scene asked for last, and what hears that it is there. */
  private record Awaited(Path path, Runnable opened) {}

  private final Place place;
  private final Tasks tasks;
  private final Questions questions;
  private final Recovery recovery;
  private final KeptWork kept;
  private final ConversionOffer conversion;
  private @Nullable Awaited awaited;

  DocumentOpening(
      Place place, NodeCatalogue catalogue, Tasks tasks, Questions questions, Recovery recovery) {
    this.place = place;
    this.tasks = tasks;
    this.questions = questions;
    this.recovery = recovery;
    conversion = new ConversionOffer(catalogue, tasks, questions, this::read);
    kept = new KeptWork(recovery, questions, place.say());
  }

  /** With a scene, and with the question what is to become of changes that a crash has left. */
  void begin(Optional<Path> scene) {
    Optional<Questions.Left> answer = kept.offer(this::restore);
    if (!answer.equals(Optional.of(Questions.Left.RESTORE))) {
      scene.ifPresent(path -> open(path, () -> {}));
    }
  }

  /** Asks again what is to become of changes that a crash has left. */
  void askAboutKept() {
    if (kept.offer(this::restore).isEmpty()) {
      questions.tell(Texts.of("window.nokept"));
    }
  }

  private void restore(Recovery.Kept left) {
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
   * Opens a scene in place of the one that is open, which the author may save first.
   *
   * @param opened hears that the scene is there
   */
  void open(Path path, Runnable opened) {
    awaited = new Awaited(path, opened);
    place
        .saves()
        .leaving(
            () -> {
              place.announce().accept(Texts.of("window.opening", path.getFileName()) + "\u2026");
              conversion.open(path, () -> read(path), () -> place.announce().accept(""));
            });
  }

  /** A document is open: whoever waits for it hears so. */
  void opened(Path path) {
    place.announce().accept("");
    if (awaited != null && awaited.path().equals(path)) {
      awaited.opened().run();
      awaited = null;
    }
  }

  /** Opens a file of which a problem is, such as an Inline's, in place of the scene. */
  void openElsewhere(Location where) {
    Path other = Path.of(where.file());
    if (Files.isRegularFile(other)) {
      open(other, () -> {});
    } else {
      place.say().accept(Texts.of("problems.no.file", where.file()));
    }
  }

  /** Reads the document that is open anew. */
  void reload(Path path) {
    load(Texts.of("window.reloading", path.getFileName()), () -> DocumentFile.open(path));
  }

  private void read(Path path) {
    load(Texts.of("window.opening", path.getFileName()), () -> DocumentFile.open(path));
  }

  private void load(String name, Callable<DocumentFile> opening) {
    place.announce().accept(name + "\u2026");
    Optional<Workbench> before = place.bench().get();
    long agreed = revision(before);
    tasks.run(
        name,
        opening,
        file -> {
          if (before.isPresent()
              && before.equals(place.bench().get())
              && revision(before) != agreed) {
            // Changed while the other was read.
            place.saves().leaving(() -> place.adopt().accept(file));
          } else {
            place.adopt().accept(file);
          }
        },
        failed -> {
          place.announce().accept("");
          questions.tell(String.valueOf(failed.getMessage()));
        });
  }

  private static long revision(Optional<Workbench> bench) {
    return bench.map(open -> open.session().document().revision()).orElse(0L);
  }
}
