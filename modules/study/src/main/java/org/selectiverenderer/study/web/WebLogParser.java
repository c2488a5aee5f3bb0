package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.study.web.WebExposureLog.Frame;
import org.selectiverenderer.study.web.WebExposureLog.SceneEvent;

/** Reads the log of an exposure, of which the page names the columns. */
final class WebLogParser {
  /** The page itself stops after as many, two hours at 60 pictures per second. */
  private static final int MOST_ROWS = 432_000;

  private static final int MOST_EVENTS = 100_000;
  private static final int LONGEST_NAME = 200;
  private static final double LONGEST = 86_400;
  private static final double FARTHEST = 1e9;
  private static final List<String> COLUMNS =
      List.of("t", "x", "y", "z", "yaw", "pitch", "roll", "frame_ms", "visible", "mono");

  private final Map<String, Integer> columns = new HashMap<>();

  private WebLogParser() {}

  /**
   * Reads a log.
   *
   * @throws IllegalArgumentException if it is not as the page writes it, with a sentence
   */
  static WebExposureLog log(JsonNode json) {
    WebLogParser parser = new WebLogParser();
    JsonNode named = json.path("columns");
    for (int i = 0; i < named.size(); i++) {
      parser.columns.putIfAbsent(named.path(i).asText(), i);
    }
    for (String column : COLUMNS) {
      require(parser.columns.containsKey(column), "the log has no column " + column);
    }
    JsonNode rows = json.path("rows");
    require(!rows.isEmpty() && rows.isArray(), "the log has no rows");
    require(rows.size() <= MOST_ROWS, "the log has more than " + MOST_ROWS + " rows");
    List<Frame> frames = new ArrayList<>(rows.size());
    double t = 0;
    double mono = 0;
    for (JsonNode row : rows) {
      Frame frame = parser.frame(row, frames.size() + 1);
      require(
          frame.t() >= t && frame.mono() >= mono,
          "row %d of the log goes back in time".formatted(frames.size() + 1));
      t = frame.t();
      mono = frame.mono();
      frames.add(frame);
    }
    return new WebExposureLog(frames, events(json.path("events")));
  }

  private Frame frame(JsonNode row, int number) {
    double[] cells = new double[COLUMNS.size()];
    for (int i = 0; i < cells.length; i++) {
      String column = COLUMNS.get(i);
      double most = column.equals("t") ? LONGEST : FARTHEST;
      OptionalDouble cell =
          WebRecordParser.number(row.path(columns.getOrDefault(column, -1)), -most, most);
      require(cell.isPresent(), "row %d of the log has no valid %s".formatted(number, column));
      cells[i] = cell.getAsDouble();
    }
    return new Frame(
        cells[0],
        cells[1],
        cells[2],
        cells[3],
        cells[4],
        cells[5],
        cells[6],
        cells[7],
        cells[8] != 0,
        cells[9]);
  }

  private static List<SceneEvent> events(JsonNode json) {
    require(json.size() <= MOST_EVENTS, "the log has more than " + MOST_EVENTS + " events");
    List<SceneEvent> events = new ArrayList<>();
    double before = 0;
    for (JsonNode one : json) {
      OptionalDouble t = WebRecordParser.number(one.path("t"), before, LONGEST);
      Optional<SceneEvent.Kind> known = kind(one.path("event").asText());
      if (known.isEmpty()) {
        continue; // A newer page may tell more.
      }
      SceneEvent.Kind kind = known.get();
      String node = one.path("node").asText();
      OptionalDouble choice =
          kind == SceneEvent.Kind.SWITCH
              ? WebRecordParser.number(one.path("choice"), -1, 1e6)
              : OptionalDouble.of(-1);
      require(
          t.isPresent()
              && choice.isPresent()
              && !node.isEmpty()
              && node.length() <= LONGEST_NAME
              && node.chars().noneMatch(Character::isISOControl),
          "event %d of the log is not as the page writes it".formatted(events.size() + 1));
      before = t.getAsDouble();
      events.add(new SceneEvent(before, kind, node, (int) choice.getAsDouble()));
    }
    return events;
  }

  private static Optional<SceneEvent.Kind> kind(String name) {
    return Arrays.stream(SceneEvent.Kind.values())
        .filter(kind -> kind.name().toLowerCase(Locale.ROOT).equals(name))
        .findFirst();
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
