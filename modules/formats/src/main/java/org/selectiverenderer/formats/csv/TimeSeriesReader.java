package org.selectiverenderer.formats.csv;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Reads a time series, a table of numbers with one row per time below a header that names the
 * columns in any order. Columns that the {@link TimeSeriesSpec} does not name are ignored.
 *
 * <p>A table with any error is refused, and each error is reported with its location.
 */
public final class TimeSeriesReader {
  private final TimeSeriesSpec form;
  private final ProblemCollector problems;
  private final List<double[]> rows = new ArrayList<>();
  private boolean faulty;

  private TimeSeriesReader(TimeSeriesSpec form, ProblemCollector problems) {
    this.form = form;
    this.problems = problems;
  }

  /**
   * Reads a file.
   *
   * @return one array per row, at least one, with the needed columns and then, if present, the
   *     columns of {@code together}; empty if the file has errors, which are in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<double[][]> read(TimeSeriesSpec form, Path path, ProblemCollector problems)
      throws IOException {
    TimeSeriesReader table = new TimeSeriesReader(form, problems);
    return CsvTable.read(path, form.columns(), table.new Faults()).flatMap(table::numbers);
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<double[][]> parse(
      TimeSeriesSpec form, String file, String text, ProblemCollector problems) {
    TimeSeriesReader table = new TimeSeriesReader(form, problems);
    return CsvTable.parse(file, text, form.columns(), table.new Faults()).flatMap(table::numbers);
  }

  private final class Faults implements CsvErrorHandler {
    @Override
    public void fault(SourceLocation location, String message) {
      faulty = true;
      problems.error(location, message + "; " + form.refusal());
    }

    @Override
    public void torn(SourceLocation location, String message) {
      if (form.torn()) {
        problems.info(location, "the last row is incomplete; it is ignored");
      } else {
        fault(location, message);
      }
    }
  }

  private Optional<double[][]> numbers(CsvTable table) {
    CsvErrorHandler faults = new Faults();
    List<String> columns = new ArrayList<>(form.needed());
    if (form.together().stream().anyMatch(table::has)) {
      columns.addAll(form.together());
    }
    if (table.require(columns, form.headers())) {
      table.rows().forEach(row -> row(row, columns, faults));
      if (!faulty && rows.isEmpty()) {
        faults.fault(
            SourceLocation.of(table.file()),
            form.subject() + " has no rows; at least one row is needed below the header");
      }
    }
    return faulty ? Optional.empty() : Optional.of(rows.toArray(double[][]::new));
  }

  private void row(CsvRow cells, List<String> columns, CsvErrorHandler faults) {
    double[] row = new double[columns.size()];
    boolean gap =
        form.gaps() && form.together().stream().allMatch(name -> cells.cellIfAny(name).isEmpty());
    for (int i = 0; i < row.length; i++) {
      if (gap && i >= form.needed().size()) {
        row[i] = Double.NaN;
        continue;
      }
      OptionalDouble number = CsvNumberParser.number(cells, columns.get(i), faults);
      if (number.isEmpty()) {
        return;
      }
      row[i] = number.getAsDouble();
    }
    if (rows.isEmpty() || inTime(rows.get(rows.size() - 1)[0], row[0])) {
      rows.add(row);
    } else {
      faults.fault(
          cells.location(columns.get(0)),
          "the time %s is %s than the row before"
              .formatted(cells.cell(columns.get(0)), form.strict() ? "not later" : "earlier"));
    }
  }

  private boolean inTime(double before, double now) {
    return now > before || now == before && !form.strict();
  }
}
