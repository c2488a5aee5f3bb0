package org.selectiverenderer.radiosity.work;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;

/**
 * Runs numbered tasks on all processors. Tasks write to places of their own, so the result does not
 * depend on the number of threads.
 */
public final class ParallelWork {
  private ParallelWork() {}

  /** Does the tasks {@code from} to {@code to}, without that. */
  @FunctionalInterface
  public interface Tasks {
    void run(int from, int to);
  }

  /**
   * Runs tasks 0 .. count - 1 in chunks.
   *
   * @return false if it was cancelled before all were done
   */
  public static boolean run(
      int count, int chunk, WorkProgress progress, WorkProgress.Stage stage, Tasks tasks) {
    int chunks = (count + chunk - 1) / chunk;
    AtomicInteger done = new AtomicInteger();
    IntStream.range(0, chunks)
        .parallel()
        .forEach(
            i -> {
              if (!progress.cancelled()) {
                tasks.run(i * chunk, Math.min(count, (i + 1) * chunk));
                progress.at(stage, (double) done.incrementAndGet() / chunks);
              }
            });
    return done.get() == chunks;
  }
}
