package org.selectiverenderer.experiment.headlog;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
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
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.base.files.NotWritten;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;

/**
 * Writes a head log while a session runs. Samples are handed over without waiting; a thread of its
 * own, {@code head-log}, writes them five times a second, so that whatever ends the program takes
 * at most the last fifth of a second with it. Another, {@code head-log-disk}, has the disk keep
 * them at every third time, so that a power cut takes less than a second: a disk that is slow to do
 * so must not keep the next samples in the program. A disk that is full ends the log with a
 * message, not the session.
 *
 * <p>So many samples may wait, minutes of them; while a disk is slower than that new ones are left
 * out, which is counted and told, and drawing goes on.
 */
public final class HeadLogWriter implements AutoCloseable {
  /** Samples that may wait: at 60 frames per second those of nine minutes, about 8 MB. */
  static final int MOST_WAITING = 1 << 15;

  private static final long PAUSE = 200_000_000;
  private static final int PER_FORCE = 3;

  /** Where the lines of a log go. */
  interface Lines {
    /** Takes lines, each ended; may wait. */
    void write(String text) throws IOException;

    /** Has the disk keep what was written; may wait while another thread writes more. */
    void keep() throws IOException;

    /** Ends the log. */
    void close() throws IOException;
  }

  private final Path file;
  private final Lines lines;
  private final int mostWaiting;
  private final Consumer<Problem> problem;
  private final Queue<HeadSample> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger waiting = new AtomicInteger();
  private final AtomicLong lost = new AtomicLong();
  private final Thread thread = new Thread(this::work, "head-log");
  private final ExecutorService disk =
      Executors.newSingleThreadExecutor(work -> new Thread(work, "head-log-disk"));
  private @Nullable Future<?> keeping;
  private long lostTold;
  private volatile boolean closing;
  private volatile boolean failed;

  private HeadLogWriter(Path file, Lines lines, int mostWaiting, Consumer<Problem> problem) {
    this.file = file;
    this.lines = lines;
    this.mostWaiting = mostWaiting;
    this.problem = problem;
  }

  /**
   * Begins a log: writes its description and its header.
   *
   * @param files closed with the writer, or when it cannot begin
   * @param problem hears when the log cannot go on, on the log's thread
   * @throws IOException if they cannot be written
   */
  public static HeadLogWriter open(
      HeadLogFiles files, HeadLogDescription description, Consumer<Problem> problem)
      throws IOException {
    try {
      return start(files.csv(), files.begin(description), MOST_WAITING, problem);
    } catch (IOException e) {
      files.close();
      throw NotWritten.named(files.csv(), e);
    }
  }

  /**
   * Begins to write.
   *
   * @param file for messages
   * @param mostWaiting samples
   */
  static HeadLogWriter start(Path file, Lines lines, int mostWaiting, Consumer<Problem> problem) {
    HeadLogWriter writer = new HeadLogWriter(file, lines, mostWaiting, problem);
    writer.thread.start();
    return writer;
  }

  /** Hands over a sample; called by one thread; never waits. */
  public void add(HeadSample sample) {
    if (failed) {
      return;
    }
    if (waiting.get() >= mostWaiting) {
      lost.incrementAndGet();
      return;
    }
    waiting.incrementAndGet();
    queue.add(sample);
  }

  /** How many samples were left out since the disk could not keep up. */
  public long lost() {
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
          tell(Problem.Severity.ERROR, "the head log ends here: " + reason(e));
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
              + " frames are missing from the head log here, "
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
    for (HeadSample sample = queue.poll(); sample != null; sample = queue.poll()) {
      waiting.decrementAndGet();
      rows.row(Column.cells(sample));
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
