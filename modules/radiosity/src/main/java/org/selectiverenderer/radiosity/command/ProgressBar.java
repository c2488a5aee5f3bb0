package org.selectiverenderer.radiosity.command;

import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

/**
 * A progress bar on the terminal with the stage, the share done and the time left. Ctrl-C cancels
 * the work, and the program ends when the results so far are written.
 */
final class ProgressBar implements RadiosityProgress, AutoCloseable {
  private static final int CELLS = 30;

  /** The longest time after Ctrl-C without progress before the program gives up. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private static final long TICK = 200_000_000L;

  private final Console console;
  private final boolean terminal;
  private final EndAwaiter awaiter;
  private final long start = System.nanoTime();
  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread hook = new Thread(this::cancel, "radiosity-cancel");
  private volatile boolean cancelled;
  private volatile boolean moved;
  private long shown;
  private double most;
  private String last = "";

  /** Waits for the end of the work after Ctrl-C. */
  @FunctionalInterface
  interface EndAwaiter {
    /**
     * Waits until the work has ended or so long that work without progress meanwhile is given up.
     *
     * @return whether the work has ended
     */
    boolean await(CountDownLatch ended) throws InterruptedException;
  }

  ProgressBar(Console console, boolean terminal, EndAwaiter awaiter) {
    this.console = console;
    this.terminal = terminal;
    this.awaiter = awaiter;
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Creates a bar that is drawn only on a terminal; elsewhere only whole lines are printed. */
  static ProgressBar on(Console console) {
    return new ProgressBar(
        console,
        System.console() != null,
        ended -> ended.await(PATIENCE.toMillis(), TimeUnit.MILLISECONDS));
  }

  /**
   * Cancels the work and waits for its end. On a busy machine writing may take long, so the wait is
   * given up only when there is no progress any more.
   */
  void cancel() {
    cancelled = true;
    try {
      boolean end;
      do {
        moved = false;
        end = awaiter.await(ended);
      } while (!end && moved);
      if (!end) {
        console.message("the computation did not stop in time; nothing is written");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public boolean cancelled() {
    return cancelled;
  }

  @Override
  public synchronized void at(Stage stage, double share) {
    moved = true;
    long now = System.nanoTime();
    most = Math.max(most, stage.overall(share));
    if (terminal && now - shown > TICK) {
      shown = now;
      draw(text(stage, most, (now - start) / 1e9));
    }
  }

  /** The bar, for example {@code [##### ] 50% form factors, 12 s left}. */
  static String text(RadiosityProgress.Stage stage, double done, double seconds) {
    int filled = (int) (CELLS * done);
    String left =
        done > 0.03 ? String.format(Locale.ROOT, ", %.0f s left", seconds / done * (1 - done)) : "";
    return "[%s%s] %3d%% %s%s"
        .formatted(
            "#".repeat(filled),
            " ".repeat(CELLS - filled),
            (int) (100 * done),
            stage.label(),
            left);
  }

  /** Prints a line above the bar. */
  synchronized void line(String text) {
    clear();
    console.message(text);
  }

  private void draw(String text) {
    String padding = " ".repeat(Math.max(0, last.length() - text.length()));
    console.overwrite(text + padding);
    last = text;
  }

  private void clear() {
    if (!last.isEmpty()) {
      console.overwrite(" ".repeat(last.length()));
      console.overwrite("");
      last = "";
    }
  }

  /** Removes the bar. */
  synchronized void end() {
    clear();
  }

  @Override
  public void close() {
    end();
    ended.countDown();
    if (!cancelled) {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        cancelled = true; // The program is ending already, and the hook has run or runs.
      }
    }
  }
}
