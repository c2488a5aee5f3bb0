package org.selectiverenderer.experiment.headlog;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * Reads a head log and the description beside it. A line that a crash cut off is left out and
 * mentioned; without its description a log is read as far as that goes.
 */
public final class HeadLogReader {
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .setIgnoreEmptyLines(true)
          .get();

  private final String file;
  private final Problems problems;

  private HeadLogReader(String file, Problems problems) {
    this.file = file;
    this.problems = problems;
  }

  /**
   * Reads a log.
   *
   * @param csv the log; its description is looked for beside it
   * @return empty when it has faults, which are then in {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public static Optional<HeadLog> read(Path csv, Problems problems) throws IOException {
    HeadLogReader reader = new HeadLogReader(csv.toString(), problems);
    List<HeadSample> samples =
        reader.samples(new String(Files.readAllBytes(csv), StandardCharsets.UTF_8));
    if (samples.isEmpty()) {
      if (!problems.any()) {
        problems.error(Location.of(csv.toString()), "the head log has no samples");
      }
      return Optional.empty();
    }
    return Optional.of(new HeadLog(reader.description(HeadLogDescription.beside(csv)), samples));
  }

  private HeadLogDescription description(Path json) throws IOException {
    if (!Files.isRegularFile(json)) {
      problems.warning(
          Location.of(json.toString()),
          "the head log's description is missing; rooms and areas are unknown");
      return HeadLogDescription.UNKNOWN;
    }
    try {
      return HeadLogDescription.of(
          new ObjectMapper().readTree(Files.readString(json, StandardCharsets.UTF_8)));
    } catch (JsonProcessingException e) {
      problems.warning(
          Location.of(json.toString()),
          "the head log's description is no JSON; rooms and areas are unknown");
      return HeadLogDescription.UNKNOWN;
    }
  }

  private List<HeadSample> samples(String text) {
    boolean cutOff = !text.isEmpty() && !text.endsWith("\n");
    String whole = cutOff ? text.substring(0, text.lastIndexOf('\n') + 1) : text;
    if (cutOff) {
      problems.info(Location.of(file), "the last line is cut off, as by a crash; it is left out");
    }
    List<HeadSample> samples = new ArrayList<>();
    try (CSVParser parser = CSVParser.parse(whole, FORMAT)) {
      for (Column column : Column.values()) {
        if (!parser.getHeaderNames().contains(column.header())) {
          problems.error(new Location(file, 1, 1), "a head log has a column " + column.header());
          return List.of();
        }
      }
      for (CSVRecord row : parser) {
        int line = (int) parser.getCurrentLineNumber();
        try {
          samples.add(sample(row));
        } catch (IllegalArgumentException e) {
          problems.error(
              new Location(file, line, 1), "the row is none of a head log; it is left out");
        }
      }
    } catch (IOException | UncheckedIOException | IllegalArgumentException e) {
      problems.error(Location.of(file), "this is no head log: its CSV is broken");
    }
    return samples;
  }

  private static HeadSample sample(CSVRecord row) {
    return new HeadSample(
        number(row, Column.T),
        number(row, Column.X),
        number(row, Column.Y),
        number(row, Column.Z),
        number(row, Column.YAW),
        number(row, Column.PITCH),
        number(row, Column.ROLL),
        cell(row, Column.MOTION).equals("moved"),
        cell(row, Column.OBJECT),
        cell(row, Column.DISTANCE).isEmpty() ? Double.NaN : number(row, Column.DISTANCE),
        cell(row, Column.VERSION).isEmpty() ? -1 : Integer.parseInt(cell(row, Column.VERSION)),
        names(cell(row, Column.CONE)),
        names(cell(row, Column.SCHEMAS)),
        number(row, Column.FRAME_MS));
  }

  private static String cell(CSVRecord row, Column column) {
    return row.get(column.header());
  }

  private static double number(CSVRecord row, Column column) {
    double value = Double.parseDouble(cell(row, column));
    if (!Double.isFinite(value)) {
      throw new NumberFormatException(column.header());
    }
    return value;
  }

  private static List<String> names(String cell) {
    return cell.isEmpty() ? List.of() : List.of(cell.split(" "));
  }
}
