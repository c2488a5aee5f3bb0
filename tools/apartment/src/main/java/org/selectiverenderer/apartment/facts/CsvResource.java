package org.selectiverenderer.apartment.facts;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;

/** Reads the CSV files that are resources of the program. */
final class CsvResource {

  private CsvResource() {}

  static List<CsvRow> rows(String resource) {
    try (InputStream in = CsvResource.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalStateException("the program's table " + resource + " is missing");
      }
      return CsvTable.parse(
              resource,
              in.readAllBytes(),
              (at, fault) -> {
                throw new IllegalStateException(at + ": " + fault);
              })
          .orElseThrow()
          .rows();
    } catch (IOException e) {
      throw new UncheckedIOException("the program's table " + resource + " cannot be read", e);
    }
  }
}
