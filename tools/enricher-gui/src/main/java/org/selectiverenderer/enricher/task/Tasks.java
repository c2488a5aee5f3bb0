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
 * Runs work on threads of its own and hands the results to the event dispatch thread. Work that is
 * cancelled hands nothing to anybody.
 */
public final class Tasks implements AutoCloseable {
  private static final int THREADS = 3;

  private final Executor eventThread;
  private final ExecutorService workers;
  private final ExecutorService writer;
  private final List<Task> running = new CopyOnWriteArrayList<>();
  private volatile boolean closed;

  /** Work that tells how far it is. */
  @FunctionalInterface
  public interface Work<T> {
    T run(TaskProgress progress) throws Exception;
  }

  /**
   * @param eventThread where results are handed over: {@code EventQueue::invokeLater}
   */
  public Tasks(Executor eventThread) {
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
   * Runs work that cannot tell how far it is.
   *
   * @param name as the author is told: {@code Counting polygons}
   * @param done hears the result on the event dispatch thread
   * @param failed hears instead what went wrong
   */
  public <T> Task run(String name, Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    return run(name, progress -> work.call(), done, failed);
  }

  /** Runs work that tells how far it is, otherwise as the other one. */
  public <T> Task run(String name, Work<T> work, Consumer<T> done, Consumer<Exception> failed) {
    Task task = new Task(name, System.nanoTime(), true);
    running.add(task);
    task.runs(workers.submit(() -> work(task, work, done, failed)));
    return task;
  }

  /**
   * Runs work that is not to be stopped half-way, such as writing a file: it waits for no other
   * work, cancelling it has no effect, and its result is always handed over.
   */
  public <T> Task runToEnd(
      String name, Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    Task task = new Task(name, System.nanoTime(), false);
    running.add(task);
    writer.execute(() -> work(task, progress -> work.call(), done, failed));
    return task;
  }

  private <T> void work(Task task, Work<T> work, Consumer<T> done, Consumer<Exception> failed) {
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
    running.remove(task);
    eventThread.execute(
        () -> {
          if (!closed && !task.cancelled()) {
            last.run();
          }
        });
  }

  /** What runs or waits now, the oldest first. */
  public List<Task> running() {
    running.removeIf(Task::cancelled);
    return List.copyOf(running);
  }

  /** Cancels what can be cancelled and takes no more; nobody hears of results any more. */
  @Override
  public void close() {
    closed = true;
    running.forEach(Task::cancel);
    workers.shutdownNow();
    writer.shutdown();
  }
}
