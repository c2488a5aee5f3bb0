package org.selectiverenderer.radiosity.work;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
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
    return run(count, chunk, progress, share -> progress.at(stage, share), tasks);
  }

  /**
   * Likewise, where the tasks are a part of a stage.
   *
   * @param done hears the share of the tasks that is done
   */
  public static boolean run(
      int count, int chunk, WorkProgress progress, DoubleConsumer done, Tasks tasks) {
    int chunks = (count + chunk - 1) / chunk;
    AtomicInteger finished = new AtomicInteger();
    IntStream.range(0, chunks)
        .parallel()
        .forEach(
            i -> {
              if (!progress.cancelled()) {
                tasks.run(i * chunk, Math.min(count, (i + 1) * chunk));
                done.accept((double) finished.incrementAndGet() / chunks);
              }
            });
    return finished.get() == chunks;
  }
}
