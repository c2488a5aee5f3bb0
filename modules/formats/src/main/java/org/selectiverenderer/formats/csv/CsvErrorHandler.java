package org.selectiverenderer.formats.csv;

import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Receives the errors found in a CSV table. The caller that reads the table adds their consequence
 * to the message.
 */
@FunctionalInterface
public interface CsvErrorHandler {
  /**
   * Called for an error in the file or in a cell.
   *
   * @param message says what is wrong, without a full stop
   */
  void fault(SourceLocation location, String message);

  /** Called for a row that does not match the header; the row is left out and reading goes on. */
  default void misfit(SourceLocation location, String message) {
    fault(location, message);
  }

  /** Called for a last row with fewer cells than the header, as a crash of its writer leaves it. */
  default void torn(SourceLocation location, String message) {
    misfit(location, message);
  }
}
