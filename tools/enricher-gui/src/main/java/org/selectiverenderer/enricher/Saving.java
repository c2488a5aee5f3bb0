package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.document.file.DiskState;
import org.selectiverenderer.document.file.FileChanged;
import org.selectiverenderer.enricher.session.EnricherSession;

/** Saves a document, and sees that no work is lost. Without widgets. */
final class Saving {
  private final EnricherSession session;
  private final Questions questions;
  private DiskState known = DiskState.SAME;

  Saving(EnricherSession session, Questions questions) {
    this.session = session;
    this.questions = questions;
  }

  /**
   * Saves to the document's file.
   *
   * @param review whether the author sees the changes first
   * @return whether nothing is unsaved now
   */
  boolean save(boolean review) {
    if (!session.document().modified()) {
      return true;
    }
    if (review && !questions.review(session)) {
      return false;
    }
    try {
      session.file().save();
    } catch (FileChanged e) {
      return questions.overwrite(String.valueOf(e.getMessage())) && written(this::over);
    } catch (IOException e) {
      questions.tell(String.valueOf(e.getMessage()));
      return false;
    }
    return done();
  }

  /** Saves to another file, which the author names. */
  boolean saveAs() {
    Optional<Path> target = questions.fileToSave(session.file().path());
    return target.isPresent() && written(() -> session.file().saveAs(target.get()));
  }

  @FunctionalInterface
  private interface Writing {
    void write() throws IOException;
  }

  private void over() throws IOException {
    session.file().saveOver();
  }

  private boolean written(Writing writing) {
    try {
      writing.write();
      return done();
    } catch (IOException e) {
      questions.tell(String.valueOf(e.getMessage()));
      return false;
    }
  }

  private boolean done() {
    known = DiskState.SAME;
    session.message("Saved " + session.file().path());
    return true;
  }

  /** Whether the document may be closed: nothing is unsaved, or the author does not want it. */
  boolean mayClose(boolean review) {
    if (!session.document().modified()) {
      return true;
    }
    return switch (questions.unsaved(String.valueOf(session.file().path().getFileName()))) {
      case SAVE -> save(review);
      case DISCARD -> true;
      case CANCEL -> false;
    };
  }

  /**
   * Looks whether the file has changed on the disk; asks once for each change.
   *
   * @return whether the author wants the file as it is there now
   */
  boolean wantsReload() {
    DiskState now;
    try {
      now = session.file().state();
    } catch (IOException e) {
      session.message(String.valueOf(e.getMessage()));
      return false;
    }
    boolean news = now != known;
    known = now;
    if (news && now == DiskState.GONE) {
      session.message(session.file().path() + " is gone from the disk; saving writes it again");
    }
    return news
        && now == DiskState.CHANGED
        && questions.reload(
            session.file().path()
                + ": another program has changed the file."
                + (session.document().modified() ? " Reloading loses the changes made here." : ""));
  }
}
