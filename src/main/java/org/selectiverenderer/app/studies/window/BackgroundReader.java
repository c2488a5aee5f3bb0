package org.selectiverenderer.app.studies.window;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Reads files on the thread {@code study-reader}, and hands over what was read to Swing. */
final class BackgroundReader implements AutoCloseable {
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread reader = new Thread(work, "study-reader");
            reader.setDaemon(true);
            return reader;
          });

  /**
   * Does work, one after another.
   *
   * @param then receives what it returns, on Swing's event thread
   * @param failed receives the sentence of its exception, on that thread
   */
  <T> void read(Callable<T> work, Consumer<T> then, Consumer<String> failed) {
    try {
      thread.execute(
          () -> {
            try {
              T result = work.call();
              SwingUtilities.invokeLater(() -> then.accept(result));
            } catch (Exception e) { // A window that says why is better than one that does nothing.
              String why = e.getMessage() == null ? e.toString() : e.getMessage();
              SwingUtilities.invokeLater(() -> failed.accept(why));
            }
          });
    } catch (RejectedExecutionException e) {
      failed.accept(StudyTexts.of("closing"));
    }
  }

  /** Ends the thread after the work that has begun; what waits is dropped. */
  @Override
  public void close() {
    thread.shutdownNow();
  }
}
