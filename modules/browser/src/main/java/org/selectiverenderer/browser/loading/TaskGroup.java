package org.selectiverenderer.browser.loading;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/**
 * A group of tasks that may start further tasks, with a future that completes when all of them are
 * done. No task ever waits for another, so that any number of groups may share an executor with few
 * threads. Thread-safe.
 */
final class TaskGroup {
  private final Executor executor;
  private final CompletableFuture<@Nullable Void> over = new CompletableFuture<>();
  private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();

  /** The number of unfinished tasks, plus 1 until the owner has started all of its own. */
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

  // A task that fails, even with an Error, must still end the group, because a caller waits for it
  // and gets the failure.
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
   * Declares that the owner starts no more tasks. The future completes when all tasks are done,
   * exceptionally if one of them failed.
   */
  CompletableFuture<@Nullable Void> end() {
    finished();
    return over;
  }

  /** Waits for the end; rethrows the exception of a task. */
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
