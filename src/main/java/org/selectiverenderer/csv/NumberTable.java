package org.selectiverenderer.csv;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
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
import org.selectiverenderer.x3d.Problems;

/**
 * Reads a table of numbers over time from CSV: a header that names the columns, in any order, then
 * one row per time. UTF-8 with or without a byte order mark; the decimal point is a point whatever
 * the locale. Columns that the {@link TableForm} does not name are passed over.
 *
 * <p>A table with any fault is refused: the faults are reported, each with its place.
 */
public final class NumberTable {
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180.builder().setIgnoreEmptyLines(true).get();

  private final TableForm form;
  private final String file;
  private final Problems problems;
  private String[] lines = {};
  private boolean faulty;

  private NumberTable(TableForm form, String file, Problems problems) {
    this.form = form;
    this.file = file;
    this.problems = problems;
  }

  /**
   * Reads a file.
   *
   * @return one array per row, at least one: the needed columns, then, when they are there, those
   *     that go together; empty when the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<double[][]> read(TableForm form, Path path, Problems problems)
      throws IOException {
    String name = path.toString();
    try {
      String text =
          StandardCharsets.UTF_8
              .newDecoder()
              .decode(ByteBuffer.wrap(Files.readAllBytes(path)))
              .toString();
      return parse(form, name, text, problems);
    } catch (CharacterCodingException e) {
      problems.error(Location.of(name), form.subject() + " is not UTF-8 text; " + form.refusal());
      return Optional.empty();
    }
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<double[][]> parse(
      TableForm form, String file, String text, Problems problems) {
    return new NumberTable(form, file, problems).parse(text);
  }

  private Optional<double[][]> parse(String withMark) {
    String text = withMark.startsWith("\uFEFF") ? withMark.substring(1) : withMark;
    lines = text.split("\r\n|\n|\r", -1);
    List<double[]> rows = new ArrayList<>();
    try (CSVParser parser = CSVParser.parse(text, FORMAT)) {
      int[] columns = {};
      int width = 0;
      long line = 1;
      for (CSVRecord cells : parser) {
        int at = lineOf(line, parser.getCurrentLineNumber());
        line = parser.getCurrentLineNumber() + 1;
        if (cells.getRecordNumber() == 1) {
          width = cells.size();
          columns = columns(cells, at);
          if (columns.length == 0) {
            return Optional.empty();
          }
        } else if (form.torn() && at == lines.length && cells.size() < width) {
          problems.info(new Location(file, at, 1), "the last row is not whole; it is passed over");
        } else {
          row(cells, at, columns, width, rows);
        }
      }
    } catch (IOException | UncheckedIOException e) {
      fault(Location.of(file), form.subject() + " is no CSV (a quotation mark is never closed)");
      return Optional.empty();
    }
    if (!faulty && rows.isEmpty()) {
      fault(
          Location.of(file),
          form.subject()
              + " is empty: a header "
              + String.join(",", form.needed())
              + " and at least one row are needed");
    }
    return faulty ? Optional.empty() : Optional.of(rows.toArray(double[][]::new));
  }

  /** The line on which a record begins: the first that is not empty after the one before. */
  private int lineOf(long from, long to) {
    int line = (int) from;
    while (line < to && line <= lines.length && lines[line - 1].isEmpty()) {
      line++;
    }
    return line;
  }

  private void fault(Location location, String message) {
    faulty = true;
    problems.error(location, message + "; " + form.refusal());
  }

  /** The cells of the columns that are read; empty after a fault. */
  private int[] columns(CSVRecord header, int line) {
    Map<String, Integer> at = new HashMap<>();
    Map<String, Integer> again = new LinkedHashMap<>();
    for (int cell = 0; cell < header.size(); cell++) {
      String name = header.get(cell).strip().toLowerCase(Locale.ROOT);
      if (at.putIfAbsent(name, cell) != null) {
        again.put(name, cell);
      }
    }
    List<String> wanted = new ArrayList<>(form.needed());
    if (form.together().stream().anyMatch(at::containsKey)) {
      wanted.addAll(form.together());
    }
    List<String> missing = wanted.stream().filter(name -> !at.containsKey(name)).toList();
    if (!missing.isEmpty()) {
      boolean semicolons = header.size() == 1 && header.get(0).contains(";");
      fault(
          new Location(file, line, 1),
          semicolons
              ? "the columns are separated by semicolons where commas are needed"
              : "the header lacks "
                  + String.join(", ", missing)
                  + " (it must be "
                  + form.headers()
                  + ")");
      return new int[0];
    }
    again.keySet().retainAll(wanted);
    again.forEach(
        (name, cell) -> fault(place(line, cell), "the header names the column " + name + " twice"));
    return again.isEmpty() ? wanted.stream().mapToInt(at::get).toArray() : new int[0];
  }

  private void row(CSVRecord cells, int line, int[] columns, int width, List<double[]> rows) {
    if (cells.size() != width) {
      fault(
          new Location(file, line, 1),
          "the row has %s values where the header names %s columns%s"
              .formatted(
                  cells.size(),
                  width,
                  cells.size() > width
                      ? " (a number is written with a decimal point, not with a comma)"
                      : ""));
      return;
    }
    double[] row = new double[columns.length];
    for (int i = 0; i < columns.length; i++) {
      Optional<Double> number = number(cells.get(columns[i]), place(line, columns[i]));
      if (number.isEmpty()) {
        return;
      }
      row[i] = number.get();
    }
    if (rows.isEmpty() || inTime(rows.get(rows.size() - 1)[0], row[0])) {
      rows.add(row);
    } else {
      fault(
          place(line, columns[0]),
          "the time %s is %s than the row before"
              .formatted(cells.get(columns[0]).strip(), form.strict() ? "not later" : "earlier"));
    }
  }

  private boolean inTime(double before, double now) {
    return now > before || now == before && !form.strict();
  }

  private Optional<Double> number(String cell, Location location) {
    String text = cell.strip();
    if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return Optional.of(value);
      }
    }
    String hint =
        text.matches("[+-]?\\d+,\\d+") ? " (write it with a decimal point, not with a comma)" : "";
    fault(
        location,
        text.isEmpty() ? "a number is missing" : shortened(text) + " is no number" + hint);
    return Optional.empty();
  }

  private static String shortened(String text) {
    return "'" + (text.length() > 40 ? text.substring(0, 40) + "..." : text) + "'";
  }

  /** Where a cell begins in its line, quoted cells before it included. */
  private Location place(int line, int cell) {
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
