package org.selectiverenderer.enricher;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.selectiverenderer.authoring.file.BrokenRelativeUrls;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.file.FileChangedException;
import org.selectiverenderer.authoring.file.FileState;
import org.selectiverenderer.authoring.file.SaveOperation;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentError;

/**
 * Saves a document in the background, and resolves conflicts with changes of the file by other
 * programs so that no work is lost. Requests that come while a file is being written wait until it
 * is. Has no widgets; for the event dispatch thread.
 */
final class DocumentSaver {
  private final EnricherSession session;
  private final UserPrompts questions;
  private final Predicate<Path> elsewhere;
  private final Queue<Runnable> waiting = new ArrayDeque<>();
  private boolean writing;
  private final OutsideChanges outside;

  /**
   * @param elsewhere brings another window to the front that has a file; false if none has it
   */
  DocumentSaver(EnricherSession session, UserPrompts questions, Predicate<Path> elsewhere) {
    this.session = session;
    this.elsewhere = elsewhere;
    this.questions = questions;
    this.outside = new OutsideChanges(session, questions);
  }

  /**
   * Saves to the document's file.
   *
   * @param review whether the author sees the changes first
   * @param saved runs when the file has been written
   */
  void save(boolean review, Runnable saved) {
    if (writing) {
      waiting.add(() -> save(review, saved));
    } else if (!session.document().modified()) {
      saved.run();
    } else if (faultAccepted(session.file().path())) {
      if (review) {
        review(saved);
      } else {
        write(session.file().writing(), saved);
      }
    }
  }

  /**
   * Shows the changes before they are saved. What another program has changed meanwhile is asked
   * about first, as it is none of the author's changes.
   */
  private void review(Runnable saved) {
    DocumentFile.ChangeGuard guard = session.file().guard();
    session
        .tasks()
        .run(
            Texts.of("window.looking", String.valueOf(session.file().path().getFileName())),
            guard::state,
            state -> {
              if (writing) {
                waiting.add(() -> save(true, saved));
              } else if (state == FileState.CHANGED) {
                String path = session.file().path().toString();
                outside.conflict(
                    Texts.of("merge.outside", path),
                    () -> reviewed(session.file().writing().over(), saved),
                    () -> save(true, saved));
              } else {
                reviewed(session.file().writing(), saved);
              }
            },
            failed -> reviewed(session.file().writing(), saved));
  }

  private void reviewed(SaveOperation what, Runnable saved) {
    if (questions.review(session)) {
      write(what, saved);
    }
  }

  /**
   * Returns whether the text is well formed, or else whether the author wants to save it all the
   * same.
   */
  private boolean faultAccepted(Path target) {
    Optional<DocumentError> fault = session.document().fault();
    boolean save =
        fault.isEmpty()
            || questions.saveFaulty(
                Texts.of(
                    "keep.faulty",
                    String.valueOf(target.getFileName()),
                    String.valueOf(fault.get().location().line()),
                    fault.get().message()));
    if (!save) {
      fault.ifPresent(is -> session.message(is.location() + ": " + is.message()));
    }
    return save;
  }

  /** Saves to another file, which the author names; its extension is added where it is missing. */
  void saveAs(Runnable saved) {
    if (writing) {
      waiting.add(() -> saveAs(saved));
      return;
    }
    Path now = session.file().path().toAbsolutePath();
    questions
        .fileToSave(now)
        .map(other -> SceneFileExtension.added(other, now))
        .filter(other -> !taken(other.toAbsolutePath()))
        .filter(other -> free(now, other.toAbsolutePath()))
        .filter(this::faultAccepted)
        .ifPresent(other -> saveAs(now, other, saved));
  }

  private void saveAs(Path now, Path other, Runnable saved) {
    Runnable writes =
        () ->
            write(
                other.toAbsolutePath().equals(now)
                    ? session.file().writing()
                    : session.file().writing(other),
                saved);
    switch (leftBehind(now, other.toAbsolutePath())) {
      case CANCEL -> {}
      case LEAVE -> writes.run();
      case TAKE -> takeAlong(other.toAbsolutePath(), saved);
    }
  }

  /**
   * Saves to another folder together with the files that the scene names. From the first file on
   * until the end, whatever it is, the document counts as being written.
   */
  private void takeAlong(Path other, Runnable saved) {
    writing = true;
    new PackageCommands(questions)
        .takeAlong(
            session,
            other,
            taken ->
                write(
                    session.file().writing(other),
                    () -> {
                      taken.keep();
                      saved.run();
                    },
                    taken::takeBack), // the urls fit the other folder only
            () -> {
              writing = false;
              goOn();
            });
  }

  /** Returns whether another window has the file, which is then said. */
  private boolean taken(Path other) {
    boolean taken = elsewhere.test(other);
    if (taken) {
      session.message(Texts.of("window.taken", String.valueOf(other.getFileName())));
    }
    return taken;
  }

  /** Returns whether the file may be written: it is new, or the author agrees to overwrite it. */
  private boolean free(Path now, Path other) {
    return other.equals(now)
        || !Files.exists(other)
        || FileTransaction.sink(other)
        || questions.overwrite(Texts.of("keep.exists", other.toString()));
  }

  /**
   * Returns what becomes of the files that the scene would not find from the other folder; nothing
   * has to be done where it finds them.
   */
  private UserPrompts.LeftBehind leftBehind(Path now, Path other) {
    List<String> left =
        BrokenRelativeUrls.in(session.document(), now.getParent(), other.getParent());
    if (left.isEmpty()) {
      return UserPrompts.LeftBehind.LEAVE;
    }

    return questions.leaveBehind(
        Texts.of(
            "window.left",
            String.valueOf(other.getParent()),
            left.size(),
            DecimalFormatter.grouped(left.size()),
            left.get(0),
            String.valueOf(now.getFileName())));
  }

  private void write(SaveOperation what, Runnable saved) {
    write(what, saved, Runnable::run);
  }

  /**
   * @param unsaved cleans up when the file could not be written, and runs what it is given then
   */
  private void write(SaveOperation what, Runnable saved, Consumer<Runnable> unsaved) {
    writing = true;
    session
        .tasks()
        .runToEnd(
            Texts.of("window.saving", String.valueOf(what.target().getFileName())),
            () -> {
              what.write();
              return what;
            },
            done -> {
              session.file().written(done);
              outside.taken();
              session.message(Texts.of("window.saved", done.target().toString()));
              writing = false;
              saved.run();
              goOn();
            },
            failed -> {
              unsaved.accept(
                  () -> {
                    writing = false;
                    failed(what, saved, failed);
                    goOn();
                  });
            });
  }

  private void goOn() {
    while (!writing && !waiting.isEmpty()) {
      waiting.remove().run();
    }
  }

  private void failed(SaveOperation what, Runnable saved, Exception why) {
    String sentence = String.valueOf(why.getMessage());
    if (!(why instanceof FileChangedException)) {
      questions.tell(sentence);
      return;
    }
    outside.conflict(sentence, () -> write(what.over(), saved), () -> save(false, saved));
  }

  /** Merges the document with its file, which another program may have changed. */
  void merge() {
    if (writing) {
      waiting.add(this::merge);
    } else {
      outside.merge(() -> session.message(Texts.of("merge.done")));
    }
  }

  /**
   * Takes the saved text in place of the document's, after the author has agreed.
   *
   * @param reload opens the file again, where the text cannot be taken as a step
   */
  void revert(Runnable reload) {
    Path path = session.file().path();
    if (writing) {
      waiting.add(() -> revert(reload));
    } else if (!Files.isRegularFile(path)) {
      questions.tell(Texts.of("window.nosaved", path.toString()));
    } else if (questions.revert(Texts.of("window.revert", String.valueOf(path.getFileName())))) {
      outside.take(Texts.of("window.revert.step"), reload);
    }
  }

  /**
   * Asks about unsaved changes before the document is closed.
   *
   * @param leave runs when nothing is unsaved, or the author discards the changes
   */
  void leaving(boolean review, Runnable leave) {
    if (writing) {
      waiting.add(() -> leaving(review, leave));
    } else if (!session.document().modified()) {
      leave.run();
    } else {
      switch (questions.unsaved(String.valueOf(session.file().path().getFileName()))) {
        case SAVE -> save(review, () -> leaving(review, leave));
        case DISCARD -> leave.run();
        case CANCEL -> session.message(Texts.of("window.notclosed"));
      }
    }
  }

  /**
   * Checks in the background whether the file has changed on the disk, and asks once for each
   * change what to do.
   *
   * @param reload runs when the author wants the file as it is now
   */
  void lookAtDisk(Runnable reload) {
    if (!writing) {
      DocumentFile.ChangeGuard guard = session.file().guard();
      session
          .tasks()
          .run(
              Texts.of("window.looking", String.valueOf(session.file().path().getFileName())),
              guard::state,
              state -> {
                if (!writing) {
                  outside.heard(state, reload);
                }
              },
              failed -> session.message(String.valueOf(failed.getMessage())));
    }
  }
}
