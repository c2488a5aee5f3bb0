package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.definition.SessionFlag;

/**
 * Writes the journal of a session that ran in a browser, with the events of {@link
 * org.selectiverenderer.study.session.SessionJournal}. The times are the browser's: its wall clock,
 * and where the page tells it its monotonic clock, whose origin holds until the page is closed.
 */
final class WebSessionJournal {
  /** The clocks may differ by so many seconds, as in the program's own sessions. */
  private static final double TOLERANCE = 2;

  private final List<ObjectNode> events = new ArrayList<>();
  private final Map<String, ?> resumed;
  private OptionalLong origin = OptionalLong.empty();
  private WebRecord last;

  /** When the clocks were compared last, in seconds of both. */
  private double wallBefore = Double.NaN;

  private double monoBefore;

  /**
   * Begins a journal with its first event.
   *
   * @param first the record of the first step
   * @param began members of the event that the session began
   * @param resumed members of the events that it went on in a page that was opened anew
   */
  WebSessionJournal(WebRecord first, Map<String, ?> began, Map<String, ?> resumed) {
    this.resumed = Map.copyOf(resumed);
    last = first;
    origin = first.origin();
    add(0, "session-began", "", began);
  }

  /** Begins the events of the next record. */
  void begin(WebRecord record) {
    boolean reopened = !record.origin().equals(origin);
    last = record;
    origin = record.origin();
    if (reopened) {
      wallBefore = Double.NaN;
      add(0, "resumed", "", resumed);
    }
    compareClocks();
  }

  private void compareClocks() {
    OptionalDouble mono = last.mono();
    if (mono.isEmpty()) {
      return;
    }
    double wall = last.started().toEpochMilli() * 1e-3;
    double moved = wall - wallBefore - (mono.getAsDouble() - monoBefore);
    if (Double.isNaN(wallBefore) || Math.abs(moved) > TOLERANCE) {
      wallBefore = wall;
      monoBefore = mono.getAsDouble();
    }
    if (Math.abs(moved) > TOLERANCE) { // not where there is nothing to compare with
      flag(0, SessionFlag.CLOCK_MOVED, Map.of("seconds", DecimalRounding.to(3, moved)));
    }
  }

  /** Raises a flag that concerns the step of the record. */
  void flag(double seconds, SessionFlag flag, Map<String, ?> more) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("flag", flag.spelling());
    members.putAll(more);
    add(seconds, "flag", last.step().id(), members);
  }

  /**
   * Adds an event.
   *
   * @param seconds since the step of the record began
   * @param step id of the step; empty for an event of the session
   * @param more further members: texts, numbers, booleans, lists and maps of these
   */
  void add(double seconds, String event, String step, Map<String, ?> more) {
    Instant time = last.started().plusNanos(Math.round(seconds * 1e9));
    ObjectNode line = JsonTree.object();
    line.put("time", time.truncatedTo(ChronoUnit.MILLIS).toString());
    line.put("event", event);
    if (!step.isEmpty()) {
      line.put("step", step);
    }
    more.forEach((key, value) -> line.set(key, JsonTree.of(value)));
    last.mono().ifPresent(mono -> line.put("mono", DecimalRounding.to(6, mono + seconds)));
    events.add(line);
  }

  /** Returns the events so far. */
  List<ObjectNode> events() {
    return List.copyOf(events);
  }

  /** Returns the text of the journal. */
  String text() {
    StringBuilder text = new StringBuilder();
    events.forEach(event -> text.append(event).append('\n'));
    return text.toString();
  }
}
