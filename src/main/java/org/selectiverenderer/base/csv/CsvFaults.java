package org.selectiverenderer.base.csv;

import org.selectiverenderer.base.problem.Location;

/** Hears what is wrong with a table; whoever reads it adds what becomes of it. */
@FunctionalInterface
public interface CsvFaults {
  /**
   * A fault of the file or of a cell.
   *
   * @param message says what is wrong, without a full stop
   */
  void fault(Location location, String message);

  /** A row that does not fit the header; the table lacks it, and goes on. */
  default void misfit(Location location, String message) {
    fault(location, message);
  }

  /** The last row, when it ends before the header does, as a crash leaves it. */
  default void torn(Location location, String message) {
    misfit(location, message);
  }
}
