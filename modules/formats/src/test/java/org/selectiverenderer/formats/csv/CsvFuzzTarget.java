package org.selectiverenderer.formats.csv;

import org.selectiverenderer.base.problem.ProblemCollector;

/** Tables, with every cell of a row taken as a number too. */
public final class CsvFuzzTarget {
  private CsvFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    CsvErrorHandler faults = new ProblemCollector()::error;
    CsvTable.parse("fuzz.csv", input, faults)
        .ifPresent(
            table ->
                table
                    .rows()
                    .forEach(
                        row ->
                            table
                                .header()
                                .forEach(name -> CsvNumberParser.number(row, name, faults))));
  }
}
