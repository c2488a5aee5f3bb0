package org.selectiverenderer.experiment.headlog;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.base.files.NotWritten;
import org.selectiverenderer.base.problem.Problem;

/**
 * Writes a head log while a session runs, by a thread of its own, {@code head-log}; as {@link
 * RowWriter} says.
 */
public final class HeadLogWriter implements AutoCloseable {
  /** Samples that may wait: at 60 frames per second those of nine minutes, about 8 MB. */
  static final int MOST_WAITING = 1 << 15;

  private static RowWriter.Form<HeadSample> form(boolean eyes) {
    List<Column> columns = Column.of(eyes);
    return new RowWriter.Form<>(
        "head-log",
        "the head log",
        "frames",
        sample -> columns.stream().map(column -> column.cell(sample)).toList());
  }

  /** Where the lines of a log go. */
  interface Lines {
    /** Takes lines, each ended; may wait. */
    void write(String text) throws IOException;

    /** Has the disk keep what was written; may wait while another thread writes more. */
    void keep() throws IOException;

    /** Ends the log. */
    void close() throws IOException;
  }

  private final RowWriter<HeadSample> rows;

  private HeadLogWriter(RowWriter<HeadSample> rows) {
    this.rows = rows;
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
      return start(
          files.csv(), files.begin(description), description.eyes(), MOST_WAITING, problem);
    } catch (IOException e) {
      files.close();
      throw NotWritten.named(files.csv(), e);
    }
  }

  /**
   * Begins to write.
   *
   * @param file for messages
   * @param eyes whether the log has the columns of the eyes
   * @param mostWaiting samples
   */
  static HeadLogWriter start(
      Path file, Lines lines, boolean eyes, int mostWaiting, Consumer<Problem> problem) {
    return new HeadLogWriter(RowWriter.start(file, lines, form(eyes), mostWaiting, problem));
  }

  /** Hands over a sample; called by one thread; never waits. */
  public void add(HeadSample sample) {
    rows.add(sample);
  }

  /** How many samples were left out since the disk could not keep up. */
  public long lost() {
    return rows.lost();
  }

  /**
   * Writes what is left and ends the log.
   *
   * @throws IOException if the file cannot be closed
   */
  @Override
  public void close() throws IOException {
    rows.close();
  }
}
