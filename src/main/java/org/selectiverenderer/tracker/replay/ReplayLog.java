package org.selectiverenderer.tracker.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.csv.NumberTable;
import org.selectiverenderer.base.csv.TableForm;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Recorded orientations over time: a CSV file with the columns t (seconds), yaw, pitch and roll
 * (degrees) in any order among others. Immutable.
 */
public final class ReplayLog {
  private static final TableForm FORM =
      new TableForm(
          "the log",
          "the log is not played",
          List.of("t", "yaw", "pitch", "roll"),
          List.of(),
          false,
          true);

  private final double[][] rows;

  private ReplayLog(double[][] rows) {
    this.rows = rows;
  }

  /**
   * Reads a file.
   *
   * @return empty when it has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<ReplayLog> read(Path file, Problems problems) throws IOException {
    return NumberTable.read(FORM, file, problems).map(ReplayLog::new);
  }

  /** The number of rows, at least one. */
  public int size() {
    return rows.length;
  }

  /** The time of a row, in seconds as the file has it; never less than that of the row before. */
  public double time(int row) {
    return rows[row][0];
  }

  /** From the first row to the last, in seconds. */
  public double duration() {
    return time(size() - 1) - time(0);
  }

  /** Copies a row's angles. */
  public void angles(int row, PoseSample into) {
    into.turn(rows[row][1], rows[row][2], rows[row][3]);
  }
}
