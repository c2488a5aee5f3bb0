package org.selectiverenderer.study.dataset;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.study.headlog.HeadLog;

/**
 * The events table (BIDS {@code events.tsv}) of a run: the exposure, areas that were entered and
 * left, objects whose version was switched, pauses, notes and flags, with onsets in seconds from
 * the first row of the head log.
 */
public final class RunEventsTable {
  private static final Map<String, String> TYPES = types();

  /** A row of the table; {@code cells} are those between {@code trial_type} and {@code t}. */
  private record Event(
      double onset,
      double duration,
      String type,
      List<@Nullable Object> cells,
      double t,
      String wall) {}

  private final RecordedRun run;
  private final Optional<HeadLog> log;
  private final double fade;
  private final List<Event> events = new ArrayList<>();

  /** Begin of the run in {@link JournalEvent#seconds}. */
  private final OptionalDouble zero;

  private final List<Pause> pauses = new ArrayList<>();
  private @Nullable JournalEvent pausedAt;

  /**
   * A pause, in which the time of the run stands still.
   *
   * @param from begin of the pause, in seconds of real time since the run's beginning
   */
  private record Pause(double from, double seconds) {}

  private RunEventsTable(RecordedRun run, Optional<HeadLog> log, double fade) {
    this.run = run;
    this.log = log;
    this.fade = fade;
    zero = run.beganAt(log);
  }

  /** Returns the columns of {@link #rows}. */
  public static List<TableColumn> columns() {
    return List.of(
        TableColumn.number(
            "onset",
            "s",
            "when it began, in the time of the head log, which stands still in pauses"),
        TableColumn.number("duration", "s", "how long it lasted, pauses included; 0 for a moment"),
        TableColumn.category("trial_type", TYPES, "what happened"),
        TableColumn.text(
            "area", "the ProximitySensor of the area that was entered or left, its DEF"),
        TableColumn.text(
            "schemas",
            "the schemas that this put in force, separated by spaces; for a switch the one"),
        TableColumn.text("object", "the Switch of the object that was switched, its DEF"),
        TableColumn.whole("version_from", "the choice that the Switch showed before, from 0"),
        TableColumn.whole("version_to", "the choice that it shows from then on, from 0"),
        TableColumn.yesNo(
            "visible",
            "some of the object was in the view as it changed, and not hidden by others",
            "the participant could not see the change",
            "whether the object was seen as it changed, as far as rays from the eyes can tell"),
        TableColumn.whole(
            "pixels", "an estimate of how many pixels of the picture showed the object then"),
        TableColumn.number(
            "turning", "deg/s", "the rate at which the participant's view turned then"),
        TableColumn.text("text", "of a note, a problem or a flag"),
        TableColumn.number(
            "t", "s", "the time of the head log when it began, which stands still in pauses"),
        TableColumn.time("wall", "when it was told, by the clock on the wall"));
  }

  /**
   * Returns the events of a run, in the order of their onsets.
   *
   * @param log the head log of the run
   * @param fade seconds of the picture's fade-out at the end
   */
  public static List<List<@Nullable Object>> rows(
      RecordedRun run, Optional<HeadLog> log, double fade) {
    RunEventsTable found = new RunEventsTable(run, log, fade);
    run.events().forEach(found::pause);
    run.events().forEach(found::line);
    found.events.sort(Comparator.comparingDouble(Event::onset));
    return found.events.stream().map(RunEventsTable::row).toList();
  }

  private static List<@Nullable Object> row(Event event) {
    List<@Nullable Object> row = new ArrayList<>();
    row.add(DecimalRounding.to(6, event.onset()));
    row.add(event.duration());
    row.add(event.type());
    row.addAll(event.cells());
    row.add(DecimalRounding.to(6, event.t()));
    row.add(event.wall());
    return row;
  }

  private void line(JournalEvent line) {
    JsonNode members = line.members();
    switch (line.event()) {
      case "shown" -> {
        double t = members.path("t").asDouble();
        add(line, t, exposureEnd(), "exposure", cells());
      }
      case "scene" -> scene(line, members.path("what"));
      case "note" -> moment(line, "note", cells("text", line.text("text")));
      case "problem" -> moment(line, "problem", cells("text", line.text("text")));
      case "flag" -> moment(line, "flag", cells("text", line.text("flag")));
      case "heading-reset" -> moment(line, "heading-reset", cells());
      case "aborted" -> moment(line, "aborted", cells());
      default -> {
        // Other events concern the session, not the run.
      }
    }
  }

  private void scene(JournalEvent line, JsonNode what) {
    double t = what.path("t").asDouble();
    switch (what.path("event").asText()) {
      case "enter" ->
          add(line, t, left(line, what), "enter", cells("area", what, "schemas", schemas(what)));
      case "exit" -> add(line, t, t, "exit", cells("area", what, "schemas", schemas(what)));
      case "switch" ->
          add(
              line,
              t,
              t,
              "switch",
              cells(
                  "schemas", what.path("schema").asText(),
                  "object", what.path("switch").asText(),
                  "version_from", what.path("from").asInt(),
                  "version_to", what.path("to").asInt(),
                  "visible", visible(what),
                  "pixels", number(what, "pixels"),
                  "turning", number(what, "turning")));
      case "field" ->
          add(
              line,
              t,
              t,
              "field",
              cells(
                  "schemas", what.path("schema").asText(),
                  "object", what.path("object").asText(),
                  "version_from", what.path("from").asInt(),
                  "version_to", what.path("to").asInt(),
                  "visible", visible(what),
                  "pixels", number(what, "pixels"),
                  "turning", number(what, "turning"),
                  "text", what.path("quality").asText() + " of " + what.path("field").asText()));
      default -> {
        // The row of the exposure has begin and end.
      }
    }
  }

  /** Returns whether a change was seen; null in records that do not tell. */
  private static @Nullable String visible(JsonNode what) {
    JsonNode visible = what.path("visible");
    return visible.isBoolean() ? (visible.asBoolean() ? "yes" : "no") : null;
  }

  private static @Nullable Number number(JsonNode what, String member) {
    return what.path(member).isNumber() ? what.path(member).numberValue() : null;
  }

  private static String schemas(JsonNode what) {
    List<String> names = new ArrayList<>();
    what.path("schemas").forEach(name -> names.add(name.asText()));
    return String.join(" ", names);
  }

  /**
   * Collects a pause. Pauses are collected before all other events, whose times are computed from
   * them.
   */
  private void pause(JournalEvent line) {
    JournalEvent since = pausedAt;
    if (line.event().equals("paused") && since == null) {
      pausedAt = line;
    } else if (line.event().equals("continued") && since != null && zero.isPresent()) {
      Pause pause =
          new Pause(since.seconds() - zero.getAsDouble(), line.seconds() - since.seconds());
      double t = run(pause.from());
      pauses.add(pause);
      events.add(
          new Event(
              pause.from() - first(),
              DecimalRounding.to(3, pause.seconds()),
              "pause",
              cells(),
              t,
              since.time().toString()));
      pausedAt = null;
    }
  }

  /** Converts real time to the time of the run, which stands still in pauses. */
  private double run(double real) {
    double t = real;
    for (Pause pause : pauses) {
      t -= Math.max(0, Math.min(real - pause.from(), pause.seconds()));
    }
    return t;
  }

  /** Converts time of the run to real time. */
  private double real(double t) {
    double real = t;
    for (Pause pause : pauses) {
      real += pause.from() < real ? pause.seconds() : 0;
    }
    return real;
  }

  /** Returns when the exposure ends: when the picture begins to fade out. */
  private double exposureEnd() {
    return run.finished() && log.isPresent() ? RecordedRun.end(log.get()) - fade : Double.NaN;
  }

  private double first() {
    return log.map(read -> read.samples().get(0).t()).orElse(0.0);
  }

  /** Returns when an area was left: when the viewer left it, or else the log ended. */
  private double left(JournalEvent entered, JsonNode what) {
    List<JournalEvent> all = run.events();
    for (JournalEvent line : all.subList(all.indexOf(entered) + 1, all.size())) {
      JsonNode later = line.members().path("what");
      if (later.path("event").asText().equals("exit")
          && later.path("sensor").asText().equals(what.path("sensor").asText())) {
        return later.path("t").asDouble();
      }
    }
    return log.map(RecordedRun::end).orElse(Double.NaN);
  }

  /** Adds an event of which the journal has the time of the session only. */
  private void moment(JournalEvent line, String type, List<@Nullable Object> cells) {
    if (zero.isPresent()) {
      double real = Math.max(0, line.seconds() - zero.getAsDouble());
      events.add(new Event(real - first(), 0, type, cells, run(real), line.time().toString()));
    }
  }

  /**
   * Adds an event whose time in the journal is that of the run.
   *
   * @param until end of the event in the time of the run; NaN if unknown
   */
  private void add(
      JournalEvent line, double t, double until, String type, List<@Nullable Object> cells) {
    double duration =
        Double.isNaN(until)
            ? Double.NaN
            : DecimalRounding.to(6, Math.max(0, real(until) - real(t)));
    events.add(new Event(real(t) - first(), duration, type, cells, t, line.time().toString()));
  }

  /**
   * Returns the cells between {@code trial_type} and {@code t}; some are given as pairs of name and
   * value, the others are missing.
   */
  private static List<@Nullable Object> cells(@Nullable Object... given) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < given.length; i += 2) {
      Object value = given[i + 1];
      values.put(
          String.valueOf(given[i]),
          value instanceof JsonNode what ? what.path("sensor").asText() : value);
    }
    List<@Nullable Object> cells = new ArrayList<>();
    for (String column :
        List.of(
            "area",
            "schemas",
            "object",
            "version_from",
            "version_to",
            "visible",
            "pixels",
            "turning",
            "text")) {
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
    types.put("field", "an object gets another level of a quality that is the value of a field");
    types.put("pause", "the experimenter pauses; the time of the head log stands still");
    types.put("heading-reset", "straight ahead is set anew");
    types.put("note", "the experimenter's note");
    types.put("problem", "something went wrong");
    types.put("flag", "something to be known of the data's quality");
    types.put("aborted", "the experimenter ends the session");
    return types;
  }
}
