package org.selectiverenderer.formats.csv;

import java.io.IOException;
import java.nio.file.Path;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.RandomAccess;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A CSV table with a header. Column names are matched without regard to letter case and order. The
 * table keeps its text and the offsets of its rows; the cells of a row are created on request, so
 * that a long table takes hardly more memory than its file.
 */
public final class CsvTable {
  private final String file;
  private final CsvScanner scan;
  private final CsvDelimiter separator;
  private final CsvColumnSpec form;
  private final CsvErrorHandler faults;
  private final DecimalSeparator decimalSign;
  private final Map<String, Integer> columns = new LinkedHashMap<>();
  private final Map<String, Integer> again = new HashMap<>();
  private List<String> header = List.of();
  private int headerStart;

  /** The least number of cells that a row must have. */
  private int least;

  private int headerLine = 1;

  /** Two numbers per row: the offset at which it begins, and its line. */
  private int[] rows = new int[64];

  private int size;

  private CsvTable(String file, String text, CsvColumnSpec form, CsvErrorHandler faults) {
    this.file = file;
    this.faults = faults;
    this.form = form;
    separator = CsvDelimiter.of(text, form.needed());
    scan = new CsvScanner(text, separator);
    decimalSign = new DecimalSeparator(separator);
  }

  /**
   * Reads a file.
   *
   * @param faults receives the rows with too few or too many cells, which are left out
   * @return empty if the file is not UTF-8 or not CSV, which {@code faults} has received
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<CsvTable> read(Path path, CsvColumnSpec form, CsvErrorHandler faults)
      throws IOException {
    return parse(path.toString(), bytes(path), form, faults);
  }

  /**
   * Returns a file's bytes.
   *
   * @throws IOException if it cannot be read, or is a folder
   */
  public static byte[] bytes(Path path) throws IOException {
    return InputFileReader.bytes(path);
  }

  /**
   * Reads a file's bytes.
   *
   * @param file its name, for messages
   */
  public static Optional<CsvTable> parse(
      String file, byte[] bytes, CsvColumnSpec form, CsvErrorHandler faults) {
    return Utf8Decoder.decode(file, bytes, faults).flatMap(text -> parse(file, text, form, faults));
  }

  /**
   * Reads a file's bytes, without requirements on the header.
   *
   * @param file its name, for messages
   */
  public static Optional<CsvTable> parse(String file, byte[] bytes, CsvErrorHandler faults) {
    return parse(file, bytes, CsvColumnSpec.ANY, faults);
  }

  /**
   * Reads a text, without requirements on the header.
   *
   * @param file its name, for messages
   */
  public static Optional<CsvTable> parse(String file, String text, CsvErrorHandler faults) {
    return parse(file, text, CsvColumnSpec.ANY, faults);
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<CsvTable> parse(
      String file, String withMark, CsvColumnSpec form, CsvErrorHandler faults) {
    String text = withMark.startsWith("\uFEFF") ? withMark.substring(1) : withMark;
    CsvTable table = new CsvTable(file, text, form, faults);
    return table.fill() ? Optional.of(table) : Optional.empty();
  }

  private boolean fill() {
    if (scan.next()) {
      headerStart = scan.start();
      headerLine = scan.startLine();
      head(scan.cells(headerStart, scan.cells()));
      while (scan.next()) {
        row();
      }
    }
    if (scan.broken()) {
      faults.fault(
          new SourceLocation(file, scan.startLine(), scan.openQuote(scan.start())),
          "the file is not valid CSV: a quotation mark is not closed");
    }
    return !scan.broken();
  }

  private void head(String[] cells) {
    header = List.of(cells);
    for (int cell = 0; cell < cells.length; cell++) {
      String name = key(cells[cell]);
      if (form.lastCounts()) {
        columns.put(name, cell);
      } else if (columns.putIfAbsent(name, cell) != null) {
        again.putIfAbsent(name, cell);
      }
    }
    least = form.filledUp() ? 0 : least();
  }

  private int least() {
    if (form.needed().isEmpty() || !form.needed().stream().allMatch(this::has)) {
      return header.size();
    }
    return form.needed().stream().mapToInt(this::index).max().orElseThrow() + 1;
  }

  /** Returns whether the record has enough cells, and only empty ones beyond the header. */
  private boolean fits() {
    if (scan.cells() <= header.size()) {
      boolean torn = scan.last() && !form.filledUp();
      return scan.cells() >= (torn ? header.size() : least);
    }
    String[] cells = scan.cells(scan.start(), scan.cells());
    return Arrays.stream(cells).skip(header.size()).allMatch(String::isEmpty);
  }

  private void row() {
    if (fits()) {
      if (2 * size == rows.length) {
        rows = Arrays.copyOf(rows, 2 * rows.length);
      }
      rows[2 * size] = scan.start();
      rows[2 * size + 1] = scan.startLine();
      size++;
      return;
    }
    boolean commas = separator == CsvDelimiter.COMMA && scan.cells() > header.size();
    String message =
        "the row has %s values, but the header has %s columns%s"
            .formatted(
                scan.cells(),
                header.size(),
                commas ? " (write numbers with a decimal point, not a comma)" : "");
    SourceLocation place = new SourceLocation(file, scan.startLine(), 1);
    if (scan.last() && scan.cells() < header.size()) {
      faults.torn(place, message);
    } else {
      faults.misfit(place, message);
    }
  }

  /** Returns the name of the file, for messages. */
  public String file() {
    return file;
  }

  /** Returns the rows in file order; each is created on request and not kept. */
  public List<CsvRow> rows() {
    return new Rows();
  }

  private final class Rows extends AbstractList<CsvRow> implements RandomAccess {
    @Override
    public CsvRow get(int index) {
      int start = rows[2 * Objects.checkIndex(index, size)];
      String[] cells = scan.cells(start, header.size());
      return new CsvRow(CsvTable.this, cells, start, rows[2 * index + 1]);
    }

    @Override
    public int size() {
      return size;
    }
  }

  /** Returns the column names as the file writes them, stripped. */
  public List<String> header() {
    return header;
  }

  /** Returns whether the header names such a column. */
  public boolean has(String column) {
    return columns.containsKey(key(column));
  }

  /** Returns where the header names a column, which must exist. */
  public SourceLocation location(String column) {
    return place(headerStart, headerLine, index(column));
  }

  /**
   * Returns whether the header names these columns, each once; reports an error otherwise.
   *
   * @param needed the header that the file must have, for the message
   */
  public boolean require(List<String> wanted, String needed) {
    List<String> missing = wanted.stream().filter(name -> !has(name)).toList();
    if (header.isEmpty()) {
      faults.fault(new SourceLocation(file, 1, 1), "the file is empty: " + needed + " is needed");
      return false;
    }
    if (!missing.isEmpty()) {
      faults.fault(
          new SourceLocation(file, headerLine, 1),
          "the header lacks " + String.join(", ", missing) + " (it must be " + needed + ")");
      return false;
    }
    boolean once = true;
    for (String name : wanted) {
      Integer second = again.get(key(name));
      if (second != null) {
        once = false;
        faults.fault(
            place(headerStart, headerLine, second),
            "the header names the column " + name + " twice");
      }
    }
    return once;
  }

  int index(String column) {
    Integer index = columns.get(column); // most callers use the key in lower case
    if (index == null) {
      index = columns.get(key(column));
    }
    if (index == null) {
      throw new IllegalArgumentException("no column " + column);
    }
    return index;
  }

  static String key(String name) {
    return name.strip().toLowerCase(Locale.ROOT);
  }

  /** Returns where a cell of a record begins; quoted cells before it are counted correctly. */
  SourceLocation place(int record, int line, int cell) {
    return new SourceLocation(file, line, scan.column(record, cell));
  }

  DecimalSeparator decimalSign() {
    return decimalSign;
  }
}
