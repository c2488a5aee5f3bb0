package org.selectiverenderer.runtime.navigation;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.csv.CsvNumbers;
import org.selectiverenderer.csv.CsvRow;
import org.selectiverenderer.csv.CsvTable;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * Reads a {@link CameraPath} from CSV: a header {@code t,x,y,z} or {@code t,x,y,z,yaw,pitch,roll}
 * in any order, then one row per time; seconds, metres, degrees. UTF-8 with or without a byte order
 * mark; the decimal point is a point whatever the locale. Other columns are passed over.
 *
 * <p>A path with any fault is not played: the faults are reported, each with its place.
 */
public final class CameraPathReader {
  private static final List<String> PLACE = List.of("t", "x", "y", "z");
  private static final List<String> TURN = List.of("yaw", "pitch", "roll");

  private final String file;
  private final Problems problems;
  private boolean faulty;

  private CameraPathReader(String file, Problems problems) {
    this.file = file;
    this.problems = problems;
  }

  /**
   * Reads a file.
   *
   * @return empty when it has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<CameraPath> read(Path path, Problems problems) throws IOException {
    CameraPathReader reader = new CameraPathReader(path.toString(), problems);
    return CsvTable.read(path, reader::fault).flatMap(reader::path);
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<CameraPath> parse(String file, String text, Problems problems) {
    CameraPathReader reader = new CameraPathReader(file, problems);
    return CsvTable.parse(file, text, reader::fault).flatMap(reader::path);
  }

  private Optional<CameraPath> path(CsvTable table) {
    List<String> columns = new ArrayList<>(PLACE);
    if (TURN.stream().anyMatch(table::has)) {
      columns.addAll(TURN);
    }
    if (!table.require(columns, "t,x,y,z or t,x,y,z,yaw,pitch,roll")) {
      return Optional.empty();
    }
    List<double[]> rows = new ArrayList<>();
    for (CsvRow row : table.rows()) {
      row(row, columns, rows);
    }
    if (!faulty && rows.isEmpty()) {
      fault(
          Location.of(file), "the path is empty: a header t,x,y,z and at least one row are needed");
    }
    return faulty ? Optional.empty() : Optional.of(new CameraPath(rows.toArray(double[][]::new)));
  }

  private void fault(Location location, String message) {
    faulty = true;
    problems.error(location, message + "; the path is not played");
  }

  private void row(CsvRow cells, List<String> columns, List<double[]> rows) {
    double[] row = new double[columns.size()];
    for (int i = 0; i < row.length; i++) {
      OptionalDouble number = CsvNumbers.number(cells, columns.get(i), this::fault);
      if (number.isEmpty()) {
        return;
      }
      row[i] = number.getAsDouble();
    }
    if (!rows.isEmpty() && row[0] <= rows.get(rows.size() - 1)[0]) {
      fault(
          cells.location("t"),
          "the time %s is not later than the row before".formatted(cells.cell("t")));
      return;
    }
    rows.add(row);
  }
}
