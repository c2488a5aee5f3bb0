package org.selectiverenderer.csv;

import org.selectiverenderer.x3d.Location;

/** Hears what is wrong with a table; whoever reads it adds what becomes of it. */
@FunctionalInterface
public interface CsvFaults {
  /**
   * A fault.
   *
   * @param message says what is wrong, without a full stop
   */
  void fault(Location location, String message);
}
