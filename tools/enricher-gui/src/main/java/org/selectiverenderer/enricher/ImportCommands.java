package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Point;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.UndoableFileWrites;
import org.selectiverenderer.authoring.importing.ImportedModel;
import org.selectiverenderer.authoring.importing.InlineEdits;
import org.selectiverenderer.authoring.importing.ModelImporter;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.importing.ImportDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskProgress;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Imports models into the open scene: by the File menu, and as files that are dropped on it. What
 * is read in the background is dropped when its scene has been left meanwhile. For the event
 * dispatch thread.
 */
final class ImportCommands {
  private final EnricherWindow window;
  private final UserPrompts questions;

  ImportCommands(EnricherWindow window, UserPrompts questions) {
    this.window = window;
    this.questions = questions;
  }

  /** Asks for a model and imports it to the floor before the viewer. */
  void choose() {
    window
        .bench()
        .ifPresent(
            bench ->
                questions
                    .modelToImport(bench.session().file().path())
                    .ifPresent(file -> ask(bench, file, false, bench.drops()::ahead)));
  }

  /**
   * Imports a file that is dropped on the preview, the plan or the tree.
   *
   * @return false where it is dropped elsewhere; it is not imported then
   */
  boolean dropped(Path file, Component over, Point at) {
    Optional<Workbench> bench = window.bench();
    if (bench.isEmpty() || !bench.get().drops().takes(over, at)) {
      return false;
    }
    ask(bench.get(), file, true, answer -> bench.get().drops().place(over, at, answer));
    return true;
  }

  /**
   * @param place answers where the model is put
   */
  private void ask(
      Workbench bench, Path file, boolean mayOpen, Consumer<Consumer<Vector3dc>> place) {
    EnricherSession session = bench.session();
    bench.commit();
    boolean mayLink =
        new ModelImporter(session.catalogue(), session.file().path(), session.access(), () -> false)
            .mayLink(file);
    // Where the mouse is now, as the picture may change while the dialog is open.
    place.accept(
        point -> {
          if (present(bench)) {
            new ImportDialog(window.frame(), file, mayLink, mayOpen)
                .ask()
                .filter(way -> present(bench))
                .ifPresent(
                    way -> {
                      if (way == ImportDialog.Way.OPEN) {
                        window.open(file);
                      } else {
                        read(bench, file, way, point);
                      }
                    });
          }
        });
  }

  private void read(Workbench bench, Path file, ImportDialog.Way way, Vector3dc point) {
    EnricherSession session = bench.session();
    Path scene = session.file().path();
    session
        .tasks()
        .run(
            Texts.of("import.task", String.valueOf(file.getFileName())),
            progress -> {
              ModelImporter importer =
                  new ModelImporter(
                      session.catalogue(), scene, session.access(), progress::cancelled);
              return way == ImportDialog.Way.LINK ? importer.link(file) : importer.copy(file);
            },
            model -> {
              if (present(bench) && session.file().path().equals(scene)) {
                add(bench, model, point);
              }
            },
            failed -> {
              if (present(bench)) {
                questions.tell(String.valueOf(failed.getMessage()));
              }
            });
  }

  private boolean present(Workbench bench) {
    return window.bench().filter(now -> now == bench).isPresent();
  }

  private void add(Workbench bench, ImportedModel model, Vector3dc point) {
    EnricherSession session = bench.session();
    bench.commit();
    if (model.files().isEmpty()) {
      perform(bench, model, point, Optional.empty());
      return;
    }
    Path scene = session.file().path();
    session
        .tasks()
        .runWriting(
            Texts.of("import.writing", String.valueOf(model.file().getFileName())),
            progress -> write(model.files(), progress),
            UndoableFileWrites::withdraw,
            written -> {
              if (present(bench) && session.file().path().equals(scene)) {
                perform(bench, model, point, Optional.of(written));
              } else {
                withdraw(session, written);
              }
            },
            failed -> {
              if (present(bench)) {
                tell(failed);
              }
            });
  }

  /** Writes the new files of a model, off the event dispatch thread. */
  private static UndoableFileWrites write(List<UndoableFileWrite> files, TaskProgress progress)
      throws IOException {
    for (UndoableFileWrite file : files) {
      if (Files.exists(file.file(), LinkOption.NOFOLLOW_LINKS)) {
        throw new IOException(Texts.of("import.taken", file.file().toString()));
      }
    }
    return UndoableFileWrites.write(files, progress::check);
  }

  private void withdraw(EnricherSession session, UndoableFileWrites written) {
    session
        .tasks()
        .runToEnd(
            Texts.of("package.clearing"),
            () -> {
              written.withdraw();
              return true;
            },
            done -> {},
            failed -> questions.tell(String.valueOf(failed.getMessage())));
  }

  private void tell(Exception failed) {
    if (failed instanceof CancellationException) {
      window.say(Texts.of("import.cancelled"));
    } else {
      questions.tell(String.valueOf(failed.getMessage()));
    }
  }

  private void perform(
      Workbench bench, ImportedModel model, Vector3dc point, Optional<UndoableFileWrites> written) {
    EnricherSession session = bench.session();
    bench.commit();
    try {
      InlineEdits.Added added =
          new InlineEdits(session.document(), session.catalogue())
              .add(session.file().path(), model.file(), model.onto(point));
      if (written.isPresent()) {
        session.document().perform(added.edit(), written.get());
      } else {
        session.document().perform(added.edit());
      }
      bench.lookAtFilesAgain();
      session
          .document()
          .tree()
          .flatMap(tree -> tree.named(added.name()))
          .ifPresent(element -> session.select(element, this));
      int left = model.problems().size();
      window.say(
          left == 0
              ? Texts.of("import.done", added.name())
              : Texts.of(
                  "import.done.without",
                  added.name(),
                  left,
                  DecimalFormatter.grouped(left),
                  model.problems().get(0).toString()));
    } catch (EditRejectedException e) {
      written.ifPresent(files -> withdraw(session, files));
      questions.tell(String.valueOf(e.getMessage()));
    }
  }
}
