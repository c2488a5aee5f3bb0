package org.selectiverenderer.experiment.dataset;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.Rounded;
import org.selectiverenderer.experiment.headlog.HeadLog;

/**
 * What happened while a scene was shown, in the seconds of its head log: the exposure, areas that
 * were entered and left, objects that were switched, pauses, notes, flags.
 */
public final class RunEvents {
  private static final Map<String, String> TYPES = types();

  /** An event in the order of the columns, but for the times. */
  private record Event(
      double onset, double duration, String type, List<@Nullable Object> cells, String wall) {}

  private final RecordedRun run;
  private final Optional<HeadLog> log;
  private final double fade;
  private final List<Event> events = new ArrayList<>();

  /** The beginning of the run by the clock on the wall, later by the pauses so far. */
  private @Nullable OffsetDateTime zero;

  private @Nullable OffsetDateTime pausedAt;

  private RunEvents(RecordedRun run, Optional<HeadLog> log, double fade) {
    this.run = run;
    this.log = log;
    this.fade = fade;
    zero = run.started(log).orElse(null);
  }

  /** The columns of {@link #rows}. */
  public static List<TableColumn> columns() {
    return List.of(
        TableColumn.number(
            "onset",
            "s",
            "when it began, in the time of the head log, which stands still in pauses"),
        TableColumn.number("duration", "s", "how long it lasted, in the same time; 0 for a moment"),
        TableColumn.category("trial_type", TYPES, "what happened"),
        TableColumn.text(
            "area", "the ProximitySensor of the area that was entered or left, its DEF"),
        TableColumn.text(
            "schemas",
            "the schemas that this put in force, separated by spaces; for a switch the one"),
        TableColumn.text("object", "the Switch of the object that was switched, its DEF"),
        TableColumn.whole("version_from", "the choice that the Switch showed before, from 0"),
        TableColumn.whole("version_to", "the choice that it shows from then on, from 0"),
        TableColumn.text(
            "text", "of a note, a problem or a flag; of a pause the seconds that it took"),
        TableColumn.time("wall", "when it was told, by the clock on the wall"));
  }

  /**
   * The events of a run, in the order of their onsets.
   *
   * @param log of the run
   * @param fade seconds in which its picture went
   */
  public static List<List<@Nullable Object>> rows(
      RecordedRun run, Optional<HeadLog> log, double fade) {
    RunEvents found = new RunEvents(run, log, fade);
    run.events().forEach(found::line);
    found.events.sort(Comparator.comparingDouble(Event::onset));
    return found.events.stream().map(RunEvents::row).toList();
  }

  private static List<@Nullable Object> row(Event event) {
    List<@Nullable Object> row = new ArrayList<>();
    row.add(Rounded.to(6, event.onset()));
    row.add(event.duration());
    row.add(event.type());
    row.addAll(event.cells());
    row.add(event.wall());
    return row;
  }

  private void line(JournalLine line) {
    JsonNode members = line.members();
    switch (line.event()) {
      case "shown" -> {
        double t = members.path("t").asDouble();
        add(line, t, exposure(t), "exposure", cells());
      }
      case "scene" -> scene(line, members.path("what"));
      case "paused" -> {
        if (pausedAt == null) {
          pausedAt = line.time();
        }
      }
      case "continued" -> continued(line);
      case "note" -> add(line, at(line), 0, "note", cells("text", line.text("text")));
      case "problem" -> add(line, at(line), 0, "problem", cells("text", line.text("text")));
      case "flag" -> add(line, at(line), 0, "flag", cells("text", line.text("flag")));
      case "heading-reset" -> add(line, at(line), 0, "heading-reset", cells());
      case "aborted" -> add(line, at(line), 0, "aborted", cells());
      default -> {
        // Of the session, not of what was seen.
      }
    }
  }

  private void scene(JournalLine line, JsonNode what) {
    double t = what.path("t").asDouble();
    switch (what.path("event").asText()) {
      case "enter" ->
          add(line, t, stay(line, what), "enter", cells("area", what, "schemas", schemas(what)));
      case "exit" -> add(line, t, 0, "exit", cells("area", what, "schemas", schemas(what)));
      case "switch" ->
          add(
              line,
              t,
              0,
              "switch",
              cells(
                  "schemas", what.path("schema").asText(),
                  "object", what.path("switch").asText(),
                  "version_from", what.path("from").asInt(),
                  "version_to", what.path("to").asInt()));
      default -> {
        // Beginning and end are told by the exposure.
      }
    }
  }

  private static String schemas(JsonNode what) {
    List<String> names = new ArrayList<>();
    what.path("schemas").forEach(name -> names.add(name.asText()));
    return String.join(" ", names);
  }

  private void continued(JournalLine line) {
    OffsetDateTime since = pausedAt;
    OffsetDateTime from = zero;
    if (since == null || from == null) {
      return;
    }
    double onset = RecordedRun.seconds(from, since);
    double seconds = RecordedRun.seconds(since, line.time());
    add(line, onset, 0, "pause", cells("text", String.valueOf(Rounded.to(3, seconds))));
    zero = from.plusNanos(Math.round(seconds * 1e9));
    pausedAt = null;
  }

  /** When a line was told, in the time of the run; NaN when that is unknown. */
  private double at(JournalLine line) {
    OffsetDateTime from = zero;
    OffsetDateTime now = pausedAt == null ? line.time() : pausedAt;
    return from == null ? Double.NaN : Math.max(0, RecordedRun.seconds(from, now));
  }

  /** The exposure ends when the picture begins to go. */
  private double exposure(double shown) {
    return run.finished() && log.isPresent()
        ? Rounded.to(3, Math.max(0, last(log.get()) - fade - shown))
        : Double.NaN;
  }

  private static double last(HeadLog log) {
    return log.samples().get(log.samples().size() - 1).t();
  }

  /** Until the area was left, or the end of the log. */
  private double stay(JournalLine entered, JsonNode what) {
    double t = what.path("t").asDouble();
    List<JournalLine> all = run.events();
    for (JournalLine line : all.subList(all.indexOf(entered) + 1, all.size())) {
      JsonNode later = line.members().path("what");
      if (later.path("event").asText().equals("exit")
          && later.path("sensor").asText().equals(what.path("sensor").asText())) {
        return Rounded.to(6, later.path("t").asDouble() - t);
      }
    }
    return log.map(read -> Rounded.to(6, Math.max(0, last(read) - t))).orElse(Double.NaN);
  }

  private void add(
      JournalLine line, double onset, double duration, String type, List<@Nullable Object> cells) {
    if (!Double.isNaN(onset)) {
      events.add(new Event(onset, duration, type, cells, line.time().toString()));
    }
  }

  /** The cells between type and time, of which some are given by name and value. */
  private static List<@Nullable Object> cells(Object... given) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < given.length; i += 2) {
      Object value = given[i + 1];
      values.put(
          (String) given[i], value instanceof JsonNode what ? what.path("sensor").asText() : value);
    }
    List<@Nullable Object> cells = new ArrayList<>();
    for (String column :
        List.of("area", "schemas", "object", "version_from", "version_to", "text")) {
      cells.add(values.get(column));
    }
    return cells;
  }

  private static Map<String, String> types() {
    Map<String, String> types = new LinkedHashMap<>();
    types.put("exposure", "the picture is complete, until it begins to go");
    types.put("enter", "the participant enters an area, and stays for the duration");
    types.put("exit", "the participant leaves an area");
    types.put("switch", "an object gets another version");
    types.put("pause", "the experimenter pauses; the time of the head log stands still");
    types.put("heading-reset", "straight ahead is set anew");
    types.put("note", "the experimenter's note");
    types.put("problem", "something went wrong");
    types.put("flag", "something to be known of the data's quality");
    types.put("aborted", "the experimenter ends the session");
    return types;
  }
}
