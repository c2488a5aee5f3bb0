package org.selectiverenderer.enricher.task;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;

/**
 * Executes tasks on background threads and hands their results to the event dispatch thread.
 * Cancelled tasks hand over nothing.
 */
public final class TaskExecutor implements AutoCloseable {
  private static final int THREADS = 3;

  private final Executor eventThread;
  private final ExecutorService workers;
  private final ExecutorService writer;
  private final List<BackgroundTask> running = new CopyOnWriteArrayList<>();
  private volatile boolean closed;

  /** Work that reports its progress. */
  @FunctionalInterface
  public interface Work<T> {
    T run(TaskProgress progress) throws Exception;
  }

  /** Takes back the result of work. */
  @FunctionalInterface
  public interface Undo<T> {
    void undo(T result) throws Exception;
  }

  /**
   * @param eventThread executes the callbacks: {@code EventQueue::invokeLater}
   */
  public TaskExecutor(Executor eventThread) {
    this.eventThread = eventThread;
    this.workers =
        Executors.newFixedThreadPool(
            THREADS,
            work -> {
              Thread thread = new Thread(work, "enricher-task");
              thread.setDaemon(true);
              thread.setPriority(Thread.MIN_PRIORITY + 1);
              return thread;
            });
    this.writer = Executors.newSingleThreadExecutor(work -> new Thread(work, "enricher-writer"));
  }

  /**
   * Runs work that does not report its progress.
   *
   * @param name name as the status bar shows it: {@code Counting polygons}
   * @param done called with the result on the event dispatch thread
   * @param failed called instead with the exception
   */
  public <T> BackgroundTask run(
      String name, Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    return run(name, progress -> work.call(), done, failed);
  }

  /** Runs work that reports its progress, otherwise as the other method. */
  public <T> BackgroundTask run(
      String name, Work<T> work, Consumer<T> done, Consumer<Exception> failed) {
    BackgroundTask task = new BackgroundTask(name, System.nanoTime(), true, false);
    running.add(task);
    task.runs(workers.submit(() -> work(task, work, done, failed)));
    return task;
  }

  /**
   * Runs work that must not be interrupted, such as writing a file: it runs on a thread for such
   * work only, cannot be cancelled, and always hands over its result.
   */
  public <T> BackgroundTask runToEnd(
      String name, Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    BackgroundTask task = new BackgroundTask(name, System.nanoTime(), false, true);
    running.add(task);
    writer.execute(() -> work(task, progress -> work.call(), done, failed));
    return task;
  }

  /**
   * Runs work that writes files and can be cancelled, but is not interrupted: it looks at its
   * progress, removes what it has written and throws a {@link CancellationException}. It runs on
   * the thread for writing, and its end is always told.
   *
   * @param undo takes back the result of work that was cancelled at its very end, or whose executor
   *     was closed; never on the event dispatch thread. Its exception is told like that of the work
   * @param failed called with the exception, also that of a cancelled task
   */
  public <T> BackgroundTask runWriting(
      String name, Work<T> work, Undo<T> undo, Consumer<T> done, Consumer<Exception> failed) {
    BackgroundTask task = new BackgroundTask(name, System.nanoTime(), true, true);
    running.add(task);
    writer.execute(() -> writing(task, work, undo, done, failed));
    return task;
  }

  private <T> void writing(
      BackgroundTask task,
      Work<T> work,
      Undo<T> undo,
      Consumer<T> done,
      Consumer<Exception> failed) {
    Runnable handOver;
    try {
      T result = work.run(task);
      if (task.endsCancelled()) {
        undo.undo(result);
        throw new CancellationException();
      }
      handOver = () -> handOver(result, undo, done);
    } catch (Exception e) {
      handOver = () -> tell(failed, e);
    } catch (LinkageError | OutOfMemoryError | StackOverflowError e) {
      handOver = () -> tell(failed, new ExecutionException(e));
    }
    running.remove(task);
    eventThread.execute(handOver);
  }

  private <T> void handOver(T result, Undo<T> undo, Consumer<T> done) {
    if (!closed) {
      done.accept(result);
      return;
    }
    Thread last =
        new Thread(
            () -> {
              try {
                undo.undo(result);
              } catch (Exception e) {
                throw new IllegalStateException(e); // nobody is left to be told
              }
            },
            "enricher-writer");
    last.start();
  }

  private void tell(Consumer<Exception> failed, Exception why) {
    if (!closed) {
      failed.accept(why);
    }
  }

  private <T> void work(
      BackgroundTask task, Work<T> work, Consumer<T> done, Consumer<Exception> failed) {
    Runnable handOver;
    try {
      T result = work.run(task);
      handOver = () -> done.accept(result);
    } catch (CancellationException e) {
      handOver = task::cancel;
    } catch (Exception e) {
      handOver = () -> failed.accept(e);
    } catch (LinkageError | OutOfMemoryError | StackOverflowError e) {
      handOver = () -> failed.accept(new ExecutionException(e));
    }
    Runnable last = handOver;
    // It can be cancelled until its result is handed over.
    eventThread.execute(
        () -> {
          running.remove(task);
          if (!closed && !task.cancelled()) {
            last.run();
          }
        });
  }

  /** The running and waiting tasks, the oldest first. */
  public List<BackgroundTask> running() {
    running.removeIf(task -> task.cancelled() && !task.awaited());
    return List.copyOf(running);
  }

  /**
   * Cancels all tasks that can be cancelled and accepts no more; no callback is called any more.
   */
  @Override
  public void close() {
    closed = true;
    running.forEach(BackgroundTask::cancel);
    workers.shutdownNow();
    writer.shutdown();
  }
}
