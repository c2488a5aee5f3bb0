package org.selectiverenderer.radiosity.parallel;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;

/**
 * A parallel loop over numbered tasks on all processors. Tasks write to their own array elements,
 * so the result does not depend on the number of threads.
 */
public final class ParallelFor {
  private ParallelFor() {}

  /** Runs the tasks {@code from} to {@code to}, exclusive. */
  @FunctionalInterface
  public interface Tasks {
    void run(int from, int to);
  }

  /**
   * Runs tasks 0 .. count - 1 in chunks.
   *
   * @return false if the work was cancelled before all tasks were done
   */
  public static boolean run(
      int count,
      int chunk,
      RadiosityProgress progress,
      RadiosityProgress.Stage stage,
      Tasks tasks) {
    return run(count, chunk, progress, share -> progress.at(stage, share), tasks);
  }

  /**
   * Runs tasks 0 .. count - 1 in chunks, as a part of a stage.
   *
   * @param done receives the share of the tasks that is done
   */
  public static boolean run(
      int count, int chunk, RadiosityProgress progress, DoubleConsumer done, Tasks tasks) {
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
