package org.selectiverenderer.enricher;

import java.util.OptionalLong;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.packaging.WrittenFiles;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The files that a scene has taken along, and the step that changed its urls to them; in the end
 * they are kept or withdrawn, on the thread for writing. For the event dispatch thread.
 */
final class TakenFiles {
  private final EnricherSession session;
  private final UserPrompts questions;
  private final WrittenFiles files;
  private OptionalLong step = OptionalLong.empty();

  TakenFiles(EnricherSession session, UserPrompts questions, WrittenFiles files) {
    this.session = session;
    this.questions = questions;
    this.files = files;
  }

  /** Changes the urls as one step; returns false if the document refuses it, which is told. */
  boolean rewrite(Edit edit) {
    OptionalLong before = session.document().history().last();
    boolean made = session.attempt(() -> session.document().perform(edit));
    OptionalLong now = session.document().history().last();
    if (!now.equals(before)) {
      step = now;
    }
    return made;
  }

  /** Gives up what the files have replaced. */
  void keep() {
    session
        .tasks()
        .runToEnd(
            Texts.of("package.clearing"),
            () -> {
              files.keep();
              return true;
            },
            done -> {},
            failed -> questions.tell(String.valueOf(failed.getMessage())));
  }

  /**
   * Takes the urls back and removes the files. Where the author has gone on meanwhile, the urls
   * cannot be taken back alone: then the files that they name stay, which is said.
   *
   * @param ended runs at the end, whatever it is
   */
  void takeBack(Runnable ended) {
    if (step.isEmpty()) {
      withdraw(ended);
      return;
    }
    boolean back =
        session.document().history().last().equals(step)
            && session.attempt(() -> session.document().history().undo());
    if (back) {
      withdraw(ended);
    } else {
      try {
        questions.tell(Texts.of("package.stays", Texts.of("package.step")));
        keep();
      } finally {
        ended.run();
      }
    }
  }

  /**
   * Removes the files and puts back what they replaced.
   *
   * @param ended runs at the end, whatever it is
   */
  void withdraw(Runnable ended) {
    session
        .tasks()
        .runToEnd(
            Texts.of("package.clearing"),
            () -> {
              files.withdraw();
              return true;
            },
            done -> ended.run(),
            failed -> {
              try {
                questions.tell(String.valueOf(failed.getMessage()));
              } finally {
                ended.run();
              }
            });
  }
}
