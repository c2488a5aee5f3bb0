package org.selectiverenderer.experiment.headlog;

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
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;

/**
 * Writes the rows of a log while a session runs. They are handed over without waiting; a thread of
 * its own writes them five times a second, so that whatever ends the program takes at most the last
 * fifth of a second with it. Another has the disk keep them at every third time, so that a power
 * cut takes less than a second: a disk that is slow to do so must not keep the next rows in the
 * program. A disk that is full ends the log with a message, not the session.
 *
 * <p>So many rows may wait; while a disk is slower than that new ones are left out, which is
 * counted and told, and whoever hands them over goes on.
 */
final class RowWriter<T> implements AutoCloseable {
  private static final long PAUSE = 200_000_000;
  private static final int PER_FORCE = 3;

  /**
   * What is written.
   *
   * @param thread name of the thread that writes; with {@code -disk}, of the one that has them kept
   * @param log what it is called in messages, such as {@code the head log}
   * @param rows what its rows are called
   * @param cells of a row
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

  private RowWriter(
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
   * Begins to write.
   *
   * @param file for messages
   * @param mostWaiting rows
   * @param problem hears when the log cannot go on, on the log's thread
   */
  static <T> RowWriter<T> start(
      Path file,
      HeadLogWriter.Lines lines,
      Form<T> form,
      int mostWaiting,
      Consumer<Problem> problem) {
    RowWriter<T> writer = new RowWriter<>(file, lines, form, mostWaiting, problem);
    writer.thread.start();
    return writer;
  }

  /** Hands over a row; called by one thread; never waits. */
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

  /** How many rows were left out since the disk could not keep up. */
  long lost() {
    return lost.get();
  }

  private void work() {
    try {
      for (int round = 1; !failed; round++) {
        boolean last = closing; // What was added before closing is still written.
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

  /** Has the disk keep what was written: the last time here, before then on the disk's thread. */
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
    problem.accept(new Problem(severity, Location.of(file.toString()), message));
  }

  private void writeQueue() throws IOException {
    CsvText rows = CsvText.bare();
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
   * Writes what is left and ends the log.
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
