package org.selectiverenderer.csv;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.selectiverenderer.x3d.Location;

/**
 * A CSV file with a header: UTF-8 with or without a byte order mark, RFC 4180, lines that are empty
 * passed over. Columns are named in any case and in any order.
 */
public final class CsvTable {
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180.builder().setIgnoreEmptyLines(true).get();

  private final String file;
  private final String[] lines;
  private final CsvFaults faults;
  private final Map<String, Integer> columns = new LinkedHashMap<>();
  private final Map<String, Integer> again = new HashMap<>();
  private final List<String> header = new ArrayList<>();
  private final List<CsvRow> rows = new ArrayList<>();
  private int headerLine = 1;

  private CsvTable(String file, String text, CsvFaults faults) {
    this.file = file;
    this.faults = faults;
    lines = text.split("\r\n|\n|\r", -1);
  }

  /**
   * Reads a file.
   *
   * @param faults hears of rows with too few or too many cells, which the table then lacks
   * @return empty when the file is no UTF-8 or no CSV, which {@code faults} has heard
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<CsvTable> read(Path path, CsvFaults faults) throws IOException {
    String file = path.toString();
    return Utf8Text.decode(file, Files.readAllBytes(path), faults)
        .flatMap(text -> parse(file, text, faults));
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<CsvTable> parse(String file, String withMark, CsvFaults faults) {
    String text = withMark.startsWith("\uFEFF") ? withMark.substring(1) : withMark;
    CsvTable table = new CsvTable(file, text, faults);
    return table.fill(text) ? Optional.of(table) : Optional.empty();
  }

  private boolean fill(String text) {
    try (CSVParser parser = CSVParser.parse(text, FORMAT)) {
      long line = 1;
      for (CSVRecord cells : parser) {
        int at = lineOf(line, parser.getCurrentLineNumber());
        line = parser.getCurrentLineNumber() + 1;
        if (cells.getRecordNumber() == 1) {
          headerLine = at;
          head(cells);
        } else {
          row(cells, at);
        }
      }
      return true;
    } catch (IOException | UncheckedIOException e) {
      faults.fault(Location.of(file), "the file is no CSV (a quotation mark is never closed)");
      return false;
    }
  }

  /** The line on which a record begins: the first that is not empty after the one before. */
  private int lineOf(long from, long to) {
    int line = (int) from;
    while (line < to && line <= lines.length && lines[line - 1].isEmpty()) {
      line++;
    }
    return line;
  }

  private void head(CSVRecord cells) {
    for (int cell = 0; cell < cells.size(); cell++) {
      header.add(cells.get(cell).strip());
      String name = key(header.get(cell));
      if (columns.putIfAbsent(name, cell) != null) {
        again.putIfAbsent(name, cell);
      }
    }
  }

  private void row(CSVRecord cells, int line) {
    if (cells.size() == header.size()) {
      rows.add(new CsvRow(this, cells.toList(), line));
      return;
    }
    Location place = new Location(file, line, 1);
    String message =
        "the row has %s values where the header names %s columns%s"
            .formatted(
                cells.size(),
                header.size(),
                cells.size() > header.size()
                    ? " (a number is written with a decimal point, not with a comma)"
                    : "");
    if (line == lines.length && cells.size() < header.size()) {
      faults.torn(place, message);
    } else {
      faults.misfit(place, message);
    }
  }

  /** Its name, for messages. */
  public String file() {
    return file;
  }

  /** In the order of the file. */
  public List<CsvRow> rows() {
    return List.copyOf(rows);
  }

  /** Whether there is such a column. */
  public boolean has(String column) {
    return columns.containsKey(key(column));
  }

  /** Where the header names that column, which it must have. */
  public Location location(String column) {
    return place(headerLine, index(column));
  }

  /**
   * Whether the header names these columns, each once.
   *
   * @param needed what the header must be, for the message when it lacks one
   */
  public boolean require(List<String> wanted, String needed) {
    List<String> missing = wanted.stream().filter(name -> !has(name)).toList();
    if (header.isEmpty()) {
      faults.fault(Location.of(file), "the file is empty: " + needed + " is needed");
      return false;
    }
    if (!missing.isEmpty()) {
      boolean semicolons = header.size() == 1 && header.get(0).contains(";");
      faults.fault(
          new Location(file, headerLine, 1),
          semicolons
              ? "the columns are separated by semicolons where commas are needed"
              : "the header lacks " + String.join(", ", missing) + " (it must be " + needed + ")");
      return false;
    }
    boolean once = true;
    for (String name : wanted) {
      Integer second = again.get(key(name));
      if (second != null) {
        once = false;
        faults.fault(place(headerLine, second), "the header names the column " + name + " twice");
      }
    }
    return once;
  }

  int index(String column) {
    Integer index = columns.get(key(column));
    if (index == null) {
      throw new IllegalArgumentException("no column " + column);
    }
    return index;
  }

  private static String key(String name) {
    return name.strip().toLowerCase(Locale.ROOT);
  }

  /** Where a cell begins in its line, quoted cells before it included. */
  Location place(int line, int cell) {
    String text = line <= lines.length ? lines[line - 1] : "";
    int at = 0;
    boolean quoted = false;
    for (int before = cell; before > 0 && at < text.length(); at++) {
      char c = text.charAt(at);
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        before--;
      }
    }
    return new Location(file, line, at + 1);
  }
}
