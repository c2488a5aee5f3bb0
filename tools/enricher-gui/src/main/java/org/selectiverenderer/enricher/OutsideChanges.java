package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.file.ExternalFileVersion;
import org.selectiverenderer.authoring.file.FileState;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.enricher.UserPrompts.OnDisk;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Brings together a document and what other programs have made of its file: merges both, takes the
 * file's text, or keeps the document's, as the author decides. Has no widgets; for the event
 * dispatch thread.
 */
final class OutsideChanges {
  private final EnricherSession session;
  private final UserPrompts questions;
  private FileState known = FileState.SAME;

  OutsideChanges(EnricherSession session, UserPrompts questions) {
    this.session = session;
    this.questions = questions;
  }

  /** Notes that the document and its file are the same now. */
  void taken() {
    known = FileState.SAME;
  }

  /** Asks what becomes of a file that another program has changed and that is to be saved. */
  void conflict(String sentence, Runnable over, Runnable merged) {
    known = FileState.CHANGED; // asked here, so not again when the window gets the focus
    List<OnDisk> possible = new ArrayList<>(List.of(OnDisk.KEEP, OnDisk.OVERWRITE));
    if (session.document().locked().isEmpty()) {
      possible.add(OnDisk.MERGE);
    }
    switch (questions.changedOnDisk(sentence, possible)) {
      case OVERWRITE -> over.run();
      case MERGE -> merge(merged);
      case KEEP, TAKE -> session.message(Texts.of("merge.kept"));
    }
  }

  /**
   * Merges the document with its file.
   *
   * @param merged runs when that is done
   */
  void merge(Runnable merged) {
    Optional<String> common = session.file().common();
    withDisk(
        copy -> {
          String mine = session.document().text().toString();
          ThreeWayMerge merge = ThreeWayMerge.of(common, mine, copy.text());
          if (merge.count(ThreeWayMerge.Kind.THEIRS) + merge.count(ThreeWayMerge.Kind.CONFLICT)
              == 0) {
            if (edited(copy, merge.edit(Texts.of("merge.step"), List.of()))) {
              session.message(Texts.of("merge.nothing"));
              merged.run();
            }
            return;
          }
          questions
              .merge(merge)
              .ifPresent(
                  choices -> {
                    if (edited(copy, merge.edit(Texts.of("merge.step"), choices))) {
                      merged.run();
                    }
                  });
        });
  }

  /**
   * Takes the text of the file in place of the document's: as one undo step where the document
   * would then be saved as the same bytes, else by reloading.
   */
  void take(String step, Runnable reload) {
    withDisk(
        copy -> {
          DocumentSnapshot now = session.document().snapshot();
          if (now.locked().isPresent() || !copy.sameForm(now)) {
            reload.run(); // in another encoding it is another document
            return;
          }
          ThreeWayMerge all = ThreeWayMerge.of(Optional.of(now.text()), now.text(), copy.text());
          Edit edit =
              all.text(List.of()).equals(copy.text())
                  ? all.edit(step, List.of())
                  : new Edit(step, List.of(new TextEdit(0, now.text().length(), copy.text())));
          edited(copy, edit);
        });
  }

  /** Makes the edit and returns whether it was made; else the author has been told why not. */
  private boolean edited(ExternalFileVersion copy, Edit edit) {
    boolean taken = session.attempt(() -> session.file().take(copy, edit));
    if (taken) {
      known = FileState.SAME;
    }
    return taken;
  }

  private void withDisk(Consumer<ExternalFileVersion> use) {
    Path path = session.file().path();
    session
        .tasks()
        .run(
            Texts.of("merge.reading", String.valueOf(path.getFileName())),
            () -> ExternalFileVersion.read(path),
            use,
            failed -> questions.tell(String.valueOf(failed.getMessage())));
  }

  /** Asks what to do about the state of the file, unless it is known. */
  void heard(FileState now, Runnable reload) {
    if (now == known) {
      return;
    }
    known = now;
    Path path = session.file().path();
    if (now == FileState.GONE) {
      session.message(Texts.of("window.gone", path.toString()));
    } else if (now == FileState.CHANGED) {
      boolean mergeable = session.document().locked().isEmpty();
      List<OnDisk> possible =
          mergeable
              ? List.of(OnDisk.KEEP, OnDisk.TAKE, OnDisk.MERGE)
              : List.of(OnDisk.KEEP, OnDisk.TAKE);
      switch (questions.changedOnDisk(Texts.of("merge.changed", path.toString()), possible)) {
        case TAKE -> take(Texts.of("merge.step.take"), reload);
        case MERGE -> merge(() -> session.message(Texts.of("merge.done")));
        case KEEP, OVERWRITE -> session.message(Texts.of("merge.kept"));
      }
    }
  }
}
