package org.selectiverenderer.study.headlog;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.base.files.FileWriteException;
import org.selectiverenderer.base.problem.Problem;

/**
 * Writes a head log while a session runs, on the thread {@code head-log} of a {@link
 * AsyncCsvWriter}.
 */
public final class HeadLogWriter implements AutoCloseable {
  /** Capacity of the queue in samples: nine minutes at 60 frames per second, about 8 MB. */
  static final int MOST_WAITING = 1 << 15;

  private static AsyncCsvWriter.Form<HeadSample> form(boolean eyes) {
    List<HeadLogColumn> columns = HeadLogColumn.of(eyes);
    return new AsyncCsvWriter.Form<>(
        "head-log",
        "the head log",
        "frames",
        sample -> columns.stream().map(column -> column.cell(sample)).toList());
  }

  /** Takes the lines of a log. */
  interface Lines {
    /** Writes lines, each ended; may block. */
    void write(String text) throws IOException;

    /** Forces written lines to the disk; may block while another thread writes more. */
    void keep() throws IOException;

    /** Ends the log. */
    void close() throws IOException;
  }

  private final AsyncCsvWriter<HeadSample> rows;

  private HeadLogWriter(AsyncCsvWriter<HeadSample> rows) {
    this.rows = rows;
  }

  /**
   * Begins a log: writes the description and the header.
   *
   * @param files closed with the writer, or if the log cannot begin
   * @param problem receives errors that end the log, on the log's thread
   * @throws IOException if they cannot be written
   */
  public static HeadLogWriter open(
      HeadLogFiles files, HeadLogMetadata description, Consumer<Problem> problem)
      throws IOException {
    try {
      return start(
          files.csv(), files.begin(description), description.eyes(), MOST_WAITING, problem);
    } catch (IOException e) {
      files.close();
      throw FileWriteException.named(files.csv(), e);
    }
  }

  /**
   * Starts the writer's thread.
   *
   * @param file the file's name, for messages
   * @param eyes whether the log has the columns of gaze data
   * @param mostWaiting capacity of the queue in samples
   */
  static HeadLogWriter start(
      Path file, Lines lines, boolean eyes, int mostWaiting, Consumer<Problem> problem) {
    return new HeadLogWriter(AsyncCsvWriter.start(file, lines, form(eyes), mostWaiting, problem));
  }

  /** Queues a sample; called by one thread; never blocks. */
  public void add(HeadSample sample) {
    rows.add(sample);
  }

  /** Returns how many samples were dropped because the disk was too slow. */
  public long lost() {
    return rows.lost();
  }

  /**
   * Writes the remaining samples and ends the log.
   *
   * @throws IOException if the file cannot be closed
   */
  @Override
  public void close() throws IOException {
    rows.close();
  }
}
