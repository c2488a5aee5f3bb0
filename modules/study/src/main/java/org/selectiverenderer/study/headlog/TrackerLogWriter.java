package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.FileWriteException;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * Writes the records of a head tracker at the tracker's own rate, beside the head log, whose rows
 * are frames: {@code NAME_tracker.csv} beside {@code NAME.csv}, and a description, {@code
 * NAME_tracker.json}. The thread {@code tracker-log} of a {@link AsyncCsvWriter} writes the rows.
 * The file can be replayed as a tracker ({@code replay:}).
 */
public final class TrackerLogWriter implements AutoCloseable {
  /** Capacity of the queue in records: about a minute at 500 records per second. */
  private static final int MOST_WAITING = 1 << 15;

  private final AsyncCsvWriter<TrackerRecord> rows;

  private TrackerLogWriter(AsyncCsvWriter<TrackerRecord> rows) {
    this.rows = rows;
  }

  /** Returns the tracker's files beside a head log: CSV and description. */
  static List<Path> beside(Path headLog) {
    String name = String.valueOf(headLog.getFileName());
    int dot = name.lastIndexOf('.');
    String stem = (dot > 0 ? name.substring(0, dot) : name) + "_tracker";
    return List.of(headLog.resolveSibling(stem + ".csv"), headLog.resolveSibling(stem + ".json"));
  }

  /**
   * Begins the log of a tracker.
   *
   * @param headLog the head log's CSV file
   * @param replace whether existing files may be replaced
   * @param tracker the tracker's SPEC, as the user typed it
   * @param placed whether the tracker measures the position of the head, too
   * @param begun begin of the log, in seconds of the monotonic clock
   * @param problem receives errors that end the log, on the log's thread
   * @throws IOException if a file cannot be written, or exists and may not be replaced
   */
  public static TrackerLogWriter open(
      Path headLog,
      boolean replace,
      String tracker,
      boolean placed,
      double begun,
      Consumer<Problem> problem)
      throws IOException {
    Path csv = beside(headLog).get(0);
    try (FileChannel description = channel(beside(headLog).get(1), replace)) {
      DiskSync.write(
          description, description(headLog, tracker, placed).getBytes(StandardCharsets.UTF_8));
      description.force(true);
    }
    FileChannel channel = channel(csv, replace);
    try {
      DiskSync.write(
          channel,
          CsvWriter.bare()
              .row(TrackerRecord.headers(placed))
              .toString()
              .getBytes(StandardCharsets.UTF_8));
      channel.force(true);
    } catch (IOException e) {
      channel.close();
      throw FileWriteException.named(csv, e);
    }
    AsyncCsvWriter.Form<TrackerRecord> form =
        new AsyncCsvWriter.Form<>(
            "tracker-log", "the tracker's log", "records", record -> record.cells(begun, placed));
    return new TrackerLogWriter(
        AsyncCsvWriter.start(csv, lines(channel), form, MOST_WAITING, problem));
  }

  private static FileChannel channel(Path file, boolean replace) throws IOException {
    return replace
        ? PrivateFiles.open(
            file,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)
        : PrivateFiles.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  private static HeadLogWriter.Lines lines(FileChannel channel) {
    return new HeadLogWriter.Lines() {
      @Override
      public void write(String text) throws IOException {
        DiskSync.write(channel, text.getBytes(StandardCharsets.UTF_8));
      }

      @Override
      public void keep() throws IOException {
        channel.force(false);
      }

      @Override
      public void close() throws IOException {
        channel.close();
      }
    };
  }

  private static String description(Path headLog, String tracker, boolean placed) {
    ObjectNode root = JsonTree.object();
    root.put("tracker", tracker);
    root.put("head_log", String.valueOf(headLog.getFileName()));
    ObjectNode columns = root.putObject("columns");
    column(columns, "t", "seconds since this log began", "s");
    column(columns, "yaw", "heading about Y, positive to the left, before it is reset", "degrees");
    column(columns, "pitch", "about X, positive up", "degrees");
    column(columns, "roll", "about Z, positive to the left shoulder", "degrees");
    column(columns, "number", "of the record since the tracker was opened, from 1", "");
    column(columns, "wall", "date and time of the computer when it arrived, UTC", "");
    column(columns, "mono", "the computer's monotonic clock then, as in the head log", "s");
    if (placed) {
      String from = " the tracker's origin; empty if it was not measured";
      column(columns, "right", "position of the head to the right of" + from, "m");
      column(columns, "up", "position of the head above" + from, "m");
      column(columns, "back", "position of the head behind" + from, "m");
    }
    return JsonWriter.of(root);
  }

  private static void column(ObjectNode columns, String name, String meaning, String units) {
    ObjectNode column = columns.putObject(name).put("description", meaning);
    if (!units.isEmpty()) {
      column.put("units", units);
    }
  }

  /** Queues a record; called by the tracker's thread; never blocks. */
  public void add(TrackerRecord record) {
    rows.add(record);
  }

  /**
   * Writes the remaining records and ends the log.
   *
   * @throws IOException if the file cannot be closed
   */
  @Override
  public void close() throws IOException {
    rows.close();
  }
}
