package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * Reads a head log and the description beside it. A last line that a crash cut off is left out and
 * reported; without the description, rooms and areas are unknown.
 */
public final class HeadLogReader {
  private final String file;
  private final ProblemCollector problems;

  /** The columns of the log; one of an older format lacks some. */
  private final Set<HeadLogColumn> there = EnumSet.noneOf(HeadLogColumn.class);

  /** Interned names of objects. */
  private final Map<String, String> names = new HashMap<>();

  /** Interned lists of names by their text; the same ones occur in thousands of rows. */
  private final Map<String, List<String>> lists = new HashMap<>();

  private final CsvErrorHandler faults =
      new CsvErrorHandler() {
        @Override
        public void fault(SourceLocation location, String message) {
          problems.error(location, message + "; the head log is not read");
        }

        @Override
        public void misfit(SourceLocation location, String message) {
          problems.error(location, message + "; the row is left out");
        }
      };

  private HeadLogReader(String file, ProblemCollector problems) {
    this.file = file;
    this.problems = problems;
  }

  /**
   * Reads a log.
   *
   * @param csv file of the log; its description is looked for beside it
   * @return empty if the log has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<HeadLog> read(Path csv, ProblemCollector problems) throws IOException {
    HeadLogReader reader = new HeadLogReader(csv.toString(), problems);
    List<HeadSample> samples = reader.samples(InputFileReader.bytes(csv));
    if (samples.isEmpty()) {
      if (!problems.any()) {
        problems.error(SourceLocation.of(csv.toString()), "the head log has no samples");
      }
      return Optional.empty();
    }
    return Optional.of(new HeadLog(reader.description(HeadLogMetadata.beside(csv)), samples));
  }

  private HeadLogMetadata description(Path json) throws IOException {
    if (!Files.isRegularFile(json)) {
      problems.warning(
          SourceLocation.of(json.toString()),
          "the head log's description is missing; rooms and areas are unknown");
      return HeadLogMetadata.UNKNOWN;
    }
    try {
      return HeadLogMetadata.of(JsonTree.parse(InputFileReader.text(json)));
    } catch (JsonProcessingException e) {
      problems.warning(
          SourceLocation.of(json.toString()),
          "the head log's description is not valid JSON; rooms and areas are unknown");
      return HeadLogMetadata.UNKNOWN;
    }
  }

  private List<HeadSample> samples(byte[] bytes) {
    int end = bytes.length;
    while (end > 0 && bytes[end - 1] != '\n') {
      end--;
    }
    if (end < bytes.length) {
      problems.info(
          SourceLocation.of(file), "the last line is cut off, perhaps by a crash; it is left out");
    }
    List<HeadSample> samples = new ArrayList<>();
    byte[] whole = end < bytes.length ? Arrays.copyOf(bytes, end) : bytes;
    List<String> needed = HeadLogColumn.OLDEST.stream().map(HeadLogColumn::header).toList();
    CsvTable.parse(file, whole, new CsvColumnSpec(needed, false, true), faults)
        .filter(table -> table.require(needed, String.join(",", needed)))
        .ifPresent(
            table -> {
              for (HeadLogColumn column : HeadLogColumn.values()) {
                if (table.has(column.header())) {
                  there.add(column);
                }
              }
              table.rows().forEach(row -> sample(row, samples));
            });
    return samples;
  }

  private void sample(CsvRow row, List<HeadSample> samples) {
    Row cells = new Row(row);
    HeadSample sample =
        new HeadSample(
            cells.number(HeadLogColumn.T),
            cells.number(HeadLogColumn.X),
            cells.number(HeadLogColumn.Y),
            cells.number(HeadLogColumn.Z),
            cells.number(HeadLogColumn.YAW),
            cells.number(HeadLogColumn.PITCH),
            cells.number(HeadLogColumn.ROLL),
            cells.text(HeadLogColumn.MOTION).equals("moved"),
            cells.name(HeadLogColumn.OBJECT),
            cells.number(HeadLogColumn.DISTANCE, Double.NaN),
            cells.choice(HeadLogColumn.VERSION),
            cells.names(HeadLogColumn.CONE),
            cells.names(HeadLogColumn.SCHEMAS),
            cells.number(HeadLogColumn.FRAME_MS),
            cells.moment(),
            cells.eyes());
    if (cells.whole) {
      samples.add(sample);
    }
  }

  /** The cells of a row as values; {@code whole} becomes false at a cell that is not valid. */
  private final class Row {
    private final CsvRow row;
    private boolean whole = true;

    Row(CsvRow row) {
      this.row = row;
    }

    String text(HeadLogColumn column) {
      return there.contains(column) ? row.cell(column.header()) : "";
    }

    String name(HeadLogColumn column) {
      return names.computeIfAbsent(text(column), name -> name);
    }

    double number(HeadLogColumn column) {
      return whole ? CsvNumberParser.number(row, column.header(), this::fault).orElse(0) : 0;
    }

    double number(HeadLogColumn column, double empty) {
      return text(column).isEmpty() ? empty : number(column);
    }

    int choice(HeadLogColumn column) {
      double value = number(column, -1);
      if (value != Math.rint(value)) {
        fault(
            row.location(column.header()),
            CsvNumberParser.quoted(text(column)) + " is not a whole number");
      }
      return (int) value;
    }

    List<String> names(HeadLogColumn column) {
      return lists.computeIfAbsent(
          text(column), text -> text.isEmpty() ? List.of() : List.of(text.split(" ")));
    }

    HeadSample.Moment moment() {
      double visible = there.contains(HeadLogColumn.VISIBLE) ? number(HeadLogColumn.VISIBLE) : 1;
      if (whole && visible != 0 && visible != 1) {
        fault(
            row.location(HeadLogColumn.VISIBLE.header()),
            CsvNumberParser.quoted(text(HeadLogColumn.VISIBLE)) + " is neither 0 nor 1");
      }
      return new HeadSample.Moment(visible != 0, wall(), number(HeadLogColumn.MONO, Double.NaN));
    }

    /** Returns the gaze sample of the row; null if the log has no gaze data. */
    @Nullable EyeSample eyes() {
      String state = text(HeadLogColumn.EYES);
      if (state.isEmpty()) {
        return null;
      }
      if (state.equals("lost")) {
        return EyeSample.LOST;
      }
      if (!state.equals("tracked")) {
        fault(
            row.location(HeadLogColumn.EYES.header()),
            CsvNumberParser.quoted(state) + " is neither tracked nor lost");
      }
      return new EyeSample(
          true,
          number(HeadLogColumn.GAZE_YAW),
          number(HeadLogColumn.GAZE_PITCH),
          name(HeadLogColumn.GAZE_OBJECT),
          number(HeadLogColumn.GAZE_DISTANCE, Double.NaN),
          choice(HeadLogColumn.GAZE_VERSION));
    }

    private @Nullable Instant wall() {
      String text = text(HeadLogColumn.WALL);
      try {
        return text.isEmpty() ? null : Instant.parse(text);
      } catch (DateTimeParseException e) {
        fault(
            row.location(HeadLogColumn.WALL.header()),
            CsvNumberParser.quoted(text)
                + " is not a date and time such as 2026-01-31T12:00:00.000Z");
        return null;
      }
    }

    private void fault(SourceLocation location, String message) {
      whole = false;
      faults.misfit(location, message);
    }
  }
}
