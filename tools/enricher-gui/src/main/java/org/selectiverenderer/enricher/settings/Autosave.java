package org.selectiverenderer.enricher.settings;

import java.io.IOException;
import java.nio.file.Path;
import javax.swing.Timer;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Writes the unsaved changes of one session to a recovery copy every few seconds, so that a crash
 * loses little.
 */
public final class Autosave {
  private static final int EVERY_MILLISECONDS = 5000;

  private final EnricherSession session;
  private final CrashRecovery recovery;
  private final Timer timer;
  private final Object order = new Object();
  private long kept;
  private long forgotten = -1;

  public Autosave(EnricherSession session, CrashRecovery recovery) {
    this.session = session;
    this.recovery = recovery;
    this.kept = session.document().revision();
    timer = new Timer(EVERY_MILLISECONDS, event -> keep());
    timer.start();
  }

  /** Writes the recovery copy if there are new changes. */
  public void keep() {
    if (!session.document().modified() || session.document().revision() == kept) {
      return;
    }
    Path path = session.file().path();
    DocumentSnapshot snapshot = session.document().snapshot();
    kept = snapshot.revision();
    session
        .tasks()
        .run(
            Texts.of("window.keeping"),
            () -> {
              write(path, snapshot);
              return path;
            },
            done -> {},
            failed -> session.message(Texts.of("window.keeping.failed", message(failed))));
  }

  private void write(Path path, DocumentSnapshot snapshot) throws IOException {
    synchronized (order) {
      if (snapshot.revision() > forgotten) {
        recovery.keep(path, snapshot);
      }
    }
  }

  /** Deletes the recovery copy, as the changes so far are saved or discarded. */
  public void forget() {
    forget(session.file().path());
  }

  /**
   * Deletes the recovery copy of a document that has another file now.
   *
   * @param path the previous file
   */
  public void forget(Path path) {
    kept = session.document().revision();
    try {
      synchronized (order) {
        forgotten = kept;
        recovery.forget(path);
      }
    } catch (IOException e) {
      session.message(Texts.of("window.keeping.stays", message(e)));
    }
  }

  private static String message(Exception e) {
    return String.valueOf(e.getMessage());
  }

  public void dispose() {
    timer.stop();
  }
}
