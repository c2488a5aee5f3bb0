package org.selectiverenderer.command.output;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Lets a command end orderly when the user presses Ctrl-C: asks it to stop, and delays the end of
 * the process until it has, or for two seconds. Three seconds later the process ends whatever still
 * goes on: a graphics driver that is busy with an endless picture would keep JOGL, and so Java,
 * from ending.
 */
public final class InterruptHandler {
  private static final double PATIENCE = 2;
  private static final double MORE_PATIENCE = 3;

  /** The exit status of a process that Ctrl-C has ended. */
  private static final int INTERRUPTED = 130;

  private InterruptHandler() {}

  /** The work of a command that can be asked to stop. */
  @FunctionalInterface
  public interface Work {
    void run() throws IOException;
  }

  /**
   * Runs the work.
   *
   * @param stop asks the work to end; called on another thread
   */
  public static void stops(Runnable stop, Work work) throws IOException {
    CountDownLatch done = new CountDownLatch(1);
    Thread hook =
        new Thread(
            () -> {
              stop.run();
              if (!await(done, PATIENCE)) {
                haltLater();
              }
            },
            "interruption");
    Runtime.getRuntime().addShutdownHook(hook);
    try {
      work.run();
    } finally {
      done.countDown();
      remove(hook);
    }
  }

  /** The work of a command that ends when its thread is interrupted. */
  @FunctionalInterface
  public interface Waiting<T> {
    T run() throws IOException, InterruptedException;
  }

  /**
   * Runs work that waits, for example for child processes, and that ends when its thread is
   * interrupted.
   *
   * @throws CommandException if the work is interrupted
   */
  public static <T> T interrupts(Waiting<T> work) throws IOException {
    Thread working = Thread.currentThread();
    AtomicReference<T> result = new AtomicReference<>();
    stops(
        working::interrupt,
        () -> {
          try {
            result.set(work.run());
          } catch (InterruptedException e) {
            working.interrupt();
            throw CommandException.environment("interrupted");
          }
        });
    return result.get();
  }

  /** Ends the process after a time, which its other hooks have to end it before. */
  private static void haltLater() {
    Thread end =
        new Thread(
            () -> {
              await(new CountDownLatch(1), MORE_PATIENCE);
              Runtime.getRuntime().halt(INTERRUPTED);
            },
            "interruption-end");
    end.setDaemon(true);
    end.start();
  }

  private static void remove(Thread hook) {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is ending: the hook has been told that the work is done.
    }
  }

  /** Waits until the latch is open, or for a number of seconds; returns whether it is open. */
  public static boolean await(CountDownLatch latch, double seconds) {
    try {
      return latch.await((long) Math.min(1e15, seconds * 1000), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return latch.getCount() == 0;
    }
  }
}
