package org.selectiverenderer.runtime.loading;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/**
 * Tasks that start further tasks, and the moment when all of them are over. No task ever waits for
 * another, so that any number of groups may share an executor of few threads. Thread-safe.
 */
final class TaskGroup {
  private final Executor executor;
  private final CompletableFuture<@Nullable Void> over = new CompletableFuture<>();
  private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();

  /** The tasks not over yet, and the owner until it has begun all of its own. */
  private final AtomicInteger open = new AtomicInteger(1);

  TaskGroup(Executor executor) {
    this.executor = executor;
  }

  /** Runs a task on the executor. Called by the owner before {@link #end}, or by a task. */
  void start(Runnable task) {
    open.incrementAndGet();
    try {
      executor.execute(() -> run(task));
    } catch (RejectedExecutionException e) { // The loader was closed meanwhile.
      failure.compareAndSet(null, e);
      finished();
    }
  }

  // A task that fails, even by an Error, must end the group: somebody waits for it and is told.
  private void run(Runnable task) {
    try {
      task.run();
    } catch (Throwable e) {
      failure.compareAndSet(null, e);
    } finally {
      finished();
    }
  }

  private void finished() {
    if (open.decrementAndGet() == 0) {
      Throwable failed = failure.get();
      if (failed == null) {
        over.complete(null);
      } else {
        over.completeExceptionally(failed);
      }
    }
  }

  /**
   * The owner starts no more tasks of its own. Completes when all tasks are over, exceptionally if
   * one of them failed.
   */
  CompletableFuture<@Nullable Void> end() {
    finished();
    return over;
  }

  /** Waits for the end; throws what a task threw. */
  static <T> T await(CompletableFuture<T> future) {
    try {
      return future.join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      if (e.getCause() instanceof RuntimeException exception) {
        throw exception;
      }
      throw e;
    }
  }
}
