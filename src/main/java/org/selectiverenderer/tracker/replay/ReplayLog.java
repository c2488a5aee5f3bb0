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
 * (degrees) in any order among others; where the device told the place of the head, also right, up
 * and back (metres), as {@link PoseSample} has them, empty in rows without one. Immutable.
 */
public final class ReplayLog {
  private static final TableForm FORM =
      new TableForm(
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

  /** Whether it has the place of the head, too. */
  public boolean placed() {
    return rows[0].length > BACK;
  }

  /** Copies a row's angles, and its place if it has one. */
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
