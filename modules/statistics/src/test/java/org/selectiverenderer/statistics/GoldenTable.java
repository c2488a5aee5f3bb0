package org.selectiverenderer.statistics;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;

/** Compressed tables of reference values beside a test. */
public final class GoldenTable {
  private GoldenTable() {}

  /** The rows of a .csv.gz. */
  public static List<CSVRecord> read(Class<?> beside, String name) throws IOException {
    try (InputStream file = Objects.requireNonNull(beside.getResourceAsStream(name));
        InputStream data = new GZIPInputStream(file)) {
      return CSVFormat.RFC4180
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .get()
          .parse(new InputStreamReader(data, StandardCharsets.UTF_8))
          .getRecords();
    }
  }
}
