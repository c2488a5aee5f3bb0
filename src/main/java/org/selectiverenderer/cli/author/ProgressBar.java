package org.selectiverenderer.cli.author;

import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * A line on the terminal with the stage, the share done and the time left. Ctrl-C cancels the work
 * and lets the program end only when what was done is written.
 */
final class ProgressBar implements WorkProgress, AutoCloseable {
  private static final int CELLS = 30;

  /** How long the program waits for the work to end after Ctrl-C, s. */
  private static final int PATIENCE = 60;

  private static final long TICK = 200_000_000L;

  private final Console console;
  private final boolean terminal;
  private final long start = System.nanoTime();
  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread hook = new Thread(this::cancel, "radiosity-cancel");
  private volatile boolean cancelled;
  private long shown;
  private double most;
  private String last = "";

  private ProgressBar(Console console, boolean terminal) {
    this.console = console;
    this.terminal = terminal;
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** A bar that is drawn only on a terminal; elsewhere whole lines are printed alone. */
  static ProgressBar on(Console console) {
    return new ProgressBar(console, System.console() != null);
  }

  private void cancel() {
    cancelled = true;
    try {
      if (!ended.await(PATIENCE, TimeUnit.SECONDS)) {
        console.message("the work did not end in time; nothing is written");
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
    long now = System.nanoTime();
    most = Math.max(most, stage.overall(share));
    if (terminal && now - shown > TICK) {
      shown = now;
      draw(text(stage, most, (now - start) / 1e9));
    }
  }

  /** The bar, for example {@code [##### ] 50% form factors, 12 s left}. */
  static String text(WorkProgress.Stage stage, double done, double seconds) {
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
    console.err().print("\r" + text + padding);
    console.err().flush();
    last = text;
  }

  private void clear() {
    if (!last.isEmpty()) {
      console.err().print("\r" + " ".repeat(last.length()) + "\r");
      last = "";
    }
  }

  /** Takes the bar away. */
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
