package org.selectiverenderer.tracker.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.TimeSeriesReader;
import org.selectiverenderer.formats.csv.TimeSeriesSpec;
import org.selectiverenderer.tracker.PoseSample;

/**
 * A recording of poses: a CSV file with the columns t (seconds), yaw, pitch and roll (degrees) in
 * any order among others; if the device measured positions, also right, up and back (metres), as in
 * {@link PoseSample}, empty in rows without a position. Immutable.
 */
public final class ReplayLog {
  private static final TimeSeriesSpec FORM =
      new TimeSeriesSpec(
          "the log",
          "the log is not played",
          List.of("t", "yaw", "pitch", "roll"),
          List.of("right", "up", "back"),
          false,
          true,
          true);

  private static final int RIGHT = 4;
  private static final int UP = 5;
  private static final int BACK = 6;

  private final double[][] rows;

  private ReplayLog(double[][] rows) {
    this.rows = rows;
  }

  /**
   * Reads a file.
   *
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<ReplayLog> read(Path file, ProblemCollector problems) throws IOException {
    return TimeSeriesReader.read(FORM, file, problems).map(ReplayLog::new);
  }

  /** Returns the number of rows, at least one. */
  public int size() {
    return rows.length;
  }

  /**
   * Returns the time of a row in seconds, as in the file; never less than that of the previous row.
   */
  public double time(int row) {
    return rows[row][0];
  }

  /** Returns the time from the first row to the last, in seconds. */
  public double duration() {
    return time(size() - 1) - time(0);
  }

  /** Returns whether the recording has positions. */
  public boolean placed() {
    return rows[0].length > BACK;
  }

  /** Copies the angles of a row, and the position if there is one. */
  public void pose(int row, PoseSample into) {
    double[] cells = rows[row];
    into.turn(cells[1], cells[2], cells[3]);
    if (placed() && !Double.isNaN(cells[RIGHT])) {
      into.place(cells[RIGHT], cells[UP], cells[BACK]);
    } else {
      into.unplace();
    }
  }
}
