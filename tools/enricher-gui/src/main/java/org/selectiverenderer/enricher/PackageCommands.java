package org.selectiverenderer.enricher;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.packaging.PackageLayout;
import org.selectiverenderer.authoring.packaging.PackageWriter;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.authoring.packaging.ScenePackager;
import org.selectiverenderer.authoring.packaging.WrittenFiles;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.importing.PackageDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Takes all files that a scene names along: into a folder or an archive, or to where the scene is
 * saved. Has no widgets but questions; for the event dispatch thread.
 */
final class PackageCommands {
  private final UserPrompts questions;

  PackageCommands(UserPrompts questions) {
    this.questions = questions;
  }

  /** Writes a scene as it is now, saved or not, with all that it names. */
  void write(EnricherSession session, PackageDialog.Target target) {
    Path scene = session.file().path();
    if (target.zip()
        && Files.exists(target.path())
        && !questions.overwrite(Texts.of("keep.exists", target.path().toString()))) {
      return;
    }
    collect(
        session,
        Path.of(String.valueOf(scene.getFileName())),
        packed -> {
          List<PackagedFile> all = new ArrayList<>();
          all.add(packed.scene());
          all.addAll(packed.files());
          if (target.zip()) {
            write(session, all, target, now -> keep(session, now), () -> {});
          } else {
            intoFolder(session, all, target.path(), now -> keep(session, now), () -> {});
          }
        },
        () -> {});
  }

  /**
   * Copies the files that a scene names to where the scene will be saved, and changes its urls.
   *
   * @param target the scene's future file
   * @param then runs when the files are there, which have to be kept or withdrawn
   * @param ended runs instead if they could not be copied, or the author does not want it
   */
  void takeAlong(EnricherSession session, Path target, Consumer<TakenFiles> then, Runnable ended) {
    long revision = session.document().revision();
    collect(
        session,
        Path.of(String.valueOf(target.getFileName())),
        packed ->
            intoFolder(
                session,
                packed.files(),
                target.toAbsolutePath().getParent(),
                files -> {
                  TakenFiles taken = new TakenFiles(session, questions, files);
                  if (session.document().revision() != revision) {
                    questions.tell(Texts.of("package.changed"));
                    taken.withdraw(ended);
                  } else if (taken.rewrite(new Edit(Texts.of("package.step"), packed.edits()))) {
                    then.accept(taken);
                  } else {
                    taken.withdraw(ended);
                  }
                },
                ended),
        ended);
  }

  /**
   * Collects the files; one of the callbacks always runs, also when it is cancelled.
   *
   * @param ended runs if nothing is collected
   */
  private void collect(
      EnricherSession session, Path place, Consumer<ScenePackage> collected, Runnable ended) {
    Path scene = session.file().path().toAbsolutePath();
    DocumentSnapshot snapshot = session.document().snapshot();
    ContentAccessPolicy access = session.access();
    session
        .tasks()
        .runWriting(
            Texts.of("package.collecting", String.valueOf(scene.getFileName())),
            progress -> {
              Path folder = scene.getParent();
              return new ScenePackager(
                      session.catalogue(),
                      folder,
                      access,
                      PackageLayout.around(folder.toRealPath()),
                      progress::cancelled)
                  .collect(scene, snapshot, place);
            },
            packed -> {},
            packed -> {
              if (packed.left().isEmpty() || questions.without(sentence(packed), lines(packed))) {
                collected.accept(packed);
              } else {
                ended.run();
              }
            },
            failed -> tell(session, failed, ended));
  }

  private static String sentence(ScenePackage packed) {
    int left = packed.left().size();
    return Texts.of("package.left", left, DecimalFormatter.grouped(left));
  }

  private static List<String> lines(ScenePackage packed) {
    return packed.left().stream()
        .map(left -> left.file() + ": " + left.url() + " " + left.reason())
        .toList();
  }

  private void intoFolder(
      EnricherSession session,
      List<PackagedFile> files,
      Path folder,
      Consumer<WrittenFiles> written,
      Runnable ended) {
    session
        .tasks()
        .runWriting(
            Texts.of("package.comparing", folder.toString()),
            progress -> PackageWriter.conflicts(files, folder),
            conflicts -> {},
            conflicts -> {
              if (conflicts.isEmpty()
                  || questions.replace(
                      Texts.of(
                          "package.conflicts",
                          conflicts.size(),
                          DecimalFormatter.grouped(conflicts.size()),
                          folder.toString()),
                      conflicts.stream().map(Path::toString).toList())) {
                write(session, files, new PackageDialog.Target(folder, false), written, ended);
              } else {
                ended.run();
              }
            },
            failed -> tell(session, failed, ended));
  }

  private void write(
      EnricherSession session,
      List<PackagedFile> files,
      PackageDialog.Target target,
      Consumer<WrittenFiles> written,
      Runnable ended) {
    session
        .tasks()
        .runWriting(
            Texts.of("package.writing", String.valueOf(target.path().getFileName())),
            progress -> {
              DoubleConsumer share =
                  done -> {
                    progress.check();
                    progress.done(done);
                  };
              if (target.zip()) {
                return PackageWriter.intoZip(files, target.path(), share);
              }
              return PackageWriter.intoFolder(files, target.path(), share);
            },
            WrittenFiles::withdraw,
            now -> {
              int count = files.size();
              session.message(
                  Texts.of(
                      "package.done",
                      count,
                      DecimalFormatter.grouped(count),
                      target.path().toString()));
              written.accept(now);
            },
            failed -> tell(session, failed, ended));
  }

  private void keep(EnricherSession session, WrittenFiles files) {
    new TakenFiles(session, questions, files).keep();
  }

  private void tell(EnricherSession session, Exception failed, Runnable ended) {
    if (failed instanceof CancellationException) {
      session.message(Texts.of("package.cancelled"));
    } else {
      questions.tell(String.valueOf(failed.getMessage()));
    }
    ended.run();
  }
}
