package org.selectiverenderer.experiment.headlog;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problem;

/**
 * Writes a head log while a session runs. Samples are handed over without waiting; a thread of its
 * own, {@code head-log}, writes them four times a second, so that whatever ends the program takes
 * at most the last quarter of a second with it, and has the disk keep them once a second, so that a
 * power cut takes little more. A disk that is full ends the log with a message, not the session.
 */
public final class HeadLogWriter implements AutoCloseable {
  private static final long PAUSE = 250_000_000;
  private static final int PER_FORCE = 4;

  private final Path file;
  private final FileChannel channel;
  private final Consumer<Problem> problem;
  private final ConcurrentLinkedQueue<HeadSample> queue = new ConcurrentLinkedQueue<>();
  private final Thread thread = new Thread(this::work, "head-log");
  private volatile boolean closing;
  private volatile boolean failed;

  private HeadLogWriter(Path file, FileChannel channel, Consumer<Problem> problem) {
    this.file = file;
    this.channel = channel;
    this.problem = problem;
  }

  /**
   * Begins a log: writes its description and its header.
   *
   * @param file ends in .csv; the description goes beside it, ending in .json
   * @param problem hears when the log cannot go on, on the log's thread
   * @throws IOException if the files cannot be written
   */
  public static HeadLogWriter open(
      Path file, HeadLogDescription description, Consumer<Problem> problem) throws IOException {
    Files.writeString(
        HeadLogDescription.beside(file), description.json() + "\n", StandardCharsets.UTF_8);
    FileChannel channel =
        FileChannel.open(
            file,
            StandardOpenOption.CREATE,
            StandardOpenOption.WRITE,
            StandardOpenOption.TRUNCATE_EXISTING);
    HeadLogWriter writer = new HeadLogWriter(file, channel, problem);
    try {
      writer.write(Column.headers() + "\n");
    } catch (IOException e) {
      channel.close();
      throw e;
    }
    writer.thread.start();
    return writer;
  }

  /** Hands over a sample; never waits. */
  public void add(HeadSample sample) {
    if (!failed) {
      queue.add(sample);
    }
  }

  private void work() {
    for (int round = 1; !failed; round++) {
      boolean last = closing; // What was added before closing is still written.
      try {
        writeQueue();
        if (last || round % PER_FORCE == 0) {
          channel.force(false);
        }
      } catch (IOException e) {
        failed = true;
        queue.clear();
        problem.accept(
            new Problem(
                Problem.Severity.ERROR,
                Location.of(file.toString()),
                "the head log ends here: " + reason(e)));
      }
      if (last) {
        return;
      }
      LockSupport.parkNanos(PAUSE);
    }
  }

  private static String reason(IOException e) {
    String message = e.getMessage();
    return message == null ? "it cannot be written" : message;
  }

  private void writeQueue() throws IOException {
    StringBuilder lines = new StringBuilder();
    for (HeadSample sample = queue.poll(); sample != null; sample = queue.poll()) {
      lines.append(Column.line(sample)).append('\n');
    }
    if (!lines.isEmpty()) {
      write(lines.toString());
    }
  }

  private void write(String text) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
    while (bytes.hasRemaining()) {
      channel.write(bytes);
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
    channel.close();
  }
}
