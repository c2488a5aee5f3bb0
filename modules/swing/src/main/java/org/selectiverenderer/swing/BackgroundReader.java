package org.selectiverenderer.swing;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Reads files on a thread of a window, and hands over what was read to Swing. */
public final class BackgroundReader implements AutoCloseable {
  private final ExecutorService thread;
  private final String closing;

  /**
   * @param name of the thread
   * @param closing the sentence for work that comes after the end
   */
  public BackgroundReader(String name, String closing) {
    this.closing = closing;
    thread =
        Executors.newSingleThreadExecutor(
            work -> {
              Thread reader = new Thread(work, name);
              reader.setDaemon(true);
              return reader;
            });
  }

  /**
   * Does work, one after another.
   *
   * @param then receives what it returns, on Swing's event thread
   * @param failed receives the sentence of its exception, on that thread
   */
  public <T> void read(Callable<T> work, Consumer<T> then, Consumer<String> failed) {
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
      failed.accept(closing);
    }
  }

  /** Ends the thread after the work that has begun; what waits is dropped. */
  @Override
  public void close() {
    thread.shutdownNow();
  }
}
