package org.selectiverenderer.study.headlog;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvWriter;

/**
 * Writes the rows of a log asynchronously while a session runs. Rows are queued without blocking; a
 * writer thread writes them five times a second, so that a crash of the program loses at most the
 * last fifth of a second. A second thread forces every third write to the disk, so that a power cut
 * loses less than a second: a disk that is slow to do so must not delay the next rows. A full disk
 * ends the log with a message, not the session.
 *
 * <p>The queue is bounded: while it is full, new rows are dropped, counted and reported, and the
 * caller goes on.
 */
final class AsyncCsvWriter<T> implements AutoCloseable {
  private static final long PAUSE = 200_000_000;
  private static final int PER_FORCE = 3;

  /**
   * The format of a log.
   *
   * @param thread name of the writer thread; that of the thread that forces rows to the disk ends
   *     in {@code -disk}
   * @param log the log's name in messages, such as {@code the head log}
   * @param rows the name of its rows in messages
   * @param cells formats the cells of a row
   */
  record Form<T>(String thread, String log, String rows, Function<T, List<String>> cells) {}

  private final Path file;
  private final HeadLogWriter.Lines lines;
  private final Form<T> form;
  private final int mostWaiting;
  private final Consumer<Problem> problem;
  private final Queue<T> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger waiting = new AtomicInteger();
  private final AtomicLong lost = new AtomicLong();
  private final Thread thread;
  private final ExecutorService disk;
  private @Nullable Future<?> keeping;
  private long lostTold;
  private volatile boolean closing;
  private volatile boolean failed;

  private AsyncCsvWriter(
      Path file,
      HeadLogWriter.Lines lines,
      Form<T> form,
      int mostWaiting,
      Consumer<Problem> problem) {
    this.file = file;
    this.lines = lines;
    this.form = form;
    this.mostWaiting = mostWaiting;
    this.problem = problem;
    thread = new Thread(this::work, form.thread);
    disk = Executors.newSingleThreadExecutor(work -> new Thread(work, form.thread + "-disk"));
  }

  /**
   * Starts the writer thread.
   *
   * @param file the file's name, for messages
   * @param mostWaiting capacity of the queue in rows
   * @param problem receives errors that end the log, on the writer thread
   */
  static <T> AsyncCsvWriter<T> start(
      Path file,
      HeadLogWriter.Lines lines,
      Form<T> form,
      int mostWaiting,
      Consumer<Problem> problem) {
    AsyncCsvWriter<T> writer = new AsyncCsvWriter<>(file, lines, form, mostWaiting, problem);
    writer.thread.start();
    return writer;
  }

  /** Queues a row; called by one thread; never blocks. */
  void add(T row) {
    if (failed) {
      return;
    }
    if (waiting.get() >= mostWaiting) {
      lost.incrementAndGet();
      return;
    }
    waiting.incrementAndGet();
    queue.add(row);
  }

  /** Returns how many rows were dropped because the disk was too slow. */
  long lost() {
    return lost.get();
  }

  private void work() {
    try {
      for (int round = 1; !failed; round++) {
        boolean last = closing; // Rows queued before close() are still written.
        try {
          writeQueue();
          keep(last, round);
          tellLost();
        } catch (IOException | RuntimeException e) {
          failed = true;
          queue.clear();
          tell(Problem.Severity.ERROR, form.log + " ends here: " + reason(e));
        }
        if (last) {
          return;
        }
        LockSupport.parkNanos(PAUSE);
      }
    } finally {
      disk.shutdown();
    }
  }

  /** Forces written rows to the disk: on the disk's thread, the last time on this one. */
  private void keep(boolean last, int round) throws IOException {
    if (last) {
      awaitKept();
      lines.keep();
    } else if (round % PER_FORCE == 0 && (keeping == null || keeping.isDone())) {
      awaitKept();
      keeping =
          disk.submit(
              () -> {
                lines.keep();
                return null;
              });
    }
  }

  private void awaitKept() throws IOException {
    Future<?> under = keeping;
    try {
      if (under != null) {
        under.get();
      }
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      throw new IllegalStateException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted");
    }
  }

  private static String reason(Exception e) {
    if (e instanceof RuntimeException) {
      return "an internal error, please report it (" + e + ")";
    }
    String message = e.getMessage();
    return message == null ? "it cannot be written" : message;
  }

  private void tellLost() {
    long now = lost.get();
    if (now > lostTold) {
      tell(
          Problem.Severity.WARNING,
          "the disk is too slow: "
              + (now - lostTold)
              + " "
              + form.rows
              + " are missing from "
              + form.log
              + " here, "
              + now
              + " in all");
      lostTold = now;
    }
  }

  private void tell(Problem.Severity severity, String message) {
    problem.accept(new Problem(severity, SourceLocation.of(file.toString()), message));
  }

  private void writeQueue() throws IOException {
    CsvWriter rows = CsvWriter.bare();
    for (T row = queue.poll(); row != null; row = queue.poll()) {
      waiting.decrementAndGet();
      rows.row(form.cells.apply(row));
    }
    String text = rows.toString();
    if (!text.isEmpty()) {
      lines.write(text);
    }
  }

  /**
   * Writes the remaining rows and ends the log.
   *
   * @throws IOException if the file cannot be closed
   */
  @Override
  public void close() throws IOException {
    closing = true;
    LockSupport.unpark(thread);
    @Nullable InterruptedException interrupted = null;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = e;
      }
    }
    if (interrupted != null) {
      Thread.currentThread().interrupt();
    }
    lines.close();
  }
}
