package org.selectiverenderer.study.definition;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.study.definition.TriggerSettings.Code;
import org.selectiverenderer.study.definition.TriggerSettings.Line;
import org.selectiverenderer.study.definition.TriggerSettings.Signal;
import org.selectiverenderer.study.definition.TriggerSettings.Wire;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialBlock;

/** Reads the key {@code triggers} of a study. */
final class TriggerSettingsReader {
  private static final String BYTE = "[1-9]\\d?|1\\d\\d|2[0-4]\\d|25[0-5]";
  private static final double MOST_MS = 1000;
  private static final double LINE_MS = 10;

  private final StudyDesign design;

  private TriggerSettingsReader(StudyDesign design) {
    this.design = design;
  }

  static Optional<TriggerSettings> read(JsonObjectReader study, StudyDesign design) {
    return study.object("triggers", "the triggers", new TriggerSettingsReader(design)::triggers);
  }

  private TriggerSettings triggers(JsonObjectReader keys) {
    String port = keys.text("port");
    if (port.isBlank()) {
      keys.fault("port", "a serial port is needed, such as COM3 or /dev/ttyUSB0");
    }
    int speed = (int) keys.whole("speed", 50, 4_000_000, 115_200);
    Map<String, Signal> events =
        keys.object("events", "the events of triggers", this::events).orElse(Map.of());
    if (events.isEmpty() && !keys.has("events")) {
      keys.fault("events", "\"events\" is needed: which signal is sent at which event");
    }
    return new TriggerSettings(port, speed, events);
  }

  private Map<String, Signal> events(JsonObjectReader keys) {
    Map<String, Signal> events = new LinkedHashMap<>();
    for (String event : keys.names()) {
      if (!TriggerSettings.EVENTS.contains(event)) {
        keys.fault(
            event,
            "there is no event \"%s\"%s"
                .formatted(
                    event,
                    SpellingSuggester.nearest(event, TriggerSettings.EVENTS)
                        .map("; did you mean \"%s\"?"::formatted)
                        .orElse("; known are " + String.join(", ", TriggerSettings.EVENTS))));
      } else if (keys.hasObject(event)) {
        keys.object(event, "the trigger " + event, signal -> signal(event, signal))
            .ifPresent(signal -> events.put(event, signal));
      } else {
        code(event, keys, event).ifPresent(code -> events.put(event, new Code(code, 0)));
      }
    }
    return events;
  }

  private Signal signal(String event, JsonObjectReader keys) {
    boolean line = keys.has("line");
    double ms = keys.number("ms", 0, MOST_MS, line ? LINE_MS : 0);
    if (line == keys.has("byte")) {
      keys.fault("a trigger needs either a \"byte\" or a \"line\"");
    }
    if (!line) {
      return new Code(code(event, keys, "byte").orElse("1"), ms);
    }
    if (ms <= 0) {
      keys.fault("ms", "a line must be on for more than 0 ms");
    }
    return new Line(keys.choice("line", List.of(Wire.values()), Wire::spelling, Wire.RTS), ms);
  }

  /** Reads a byte: a number, or the name of a factor or column in braces. */
  private Optional<String> code(String event, JsonObjectReader keys, String key) {
    Optional<LocatedJsonValue> value = keys.value(key);
    Optional<String> text = value.flatMap(LocatedJsonValue::text);
    if (text.isEmpty()) {
      return value.map(number -> Long.toString(keys.whole(key, 1, 255, 1)));
    }
    String fault = fault(event, text.get());
    if (!fault.isEmpty()) {
      keys.fault(key, fault);
    }
    return text;
  }

  /** Returns what is wrong with a byte that is a text; empty if nothing is. */
  private String fault(String event, String text) {
    if (!text.matches("\\{[^{}]+\\}")) {
      return "a byte is a number from 1 to 255, or a column of the stimuli in braces, such as"
          + " \"{code}\"";
    }
    if (!TriggerSettings.OF_TRIALS.contains(event)) {
      return "the event %s has no stimulus; write a number from 1 to 255".formatted(event);
    }
    String column = text.substring(1, text.length() - 1);
    boolean known = false;
    for (TrialBlock block : design.blocks()) {
      Optional<StimulusList> list =
          block.stimuli().filter(stimuli -> stimuli.columns().contains(column));
      known |= list.isPresent();
      for (StimulusList.Stimulus row : list.map(StimulusList::rows).orElse(List.of())) {
        String cell = row.cells().getOrDefault(column, "");
        if (!cell.matches(BYTE)) {
          return "line %d of %s has '%s' in the column %s, which is no number from 1 to 255"
              .formatted(row.line(), list.get().file().getFileName(), cell, column);
        }
      }
    }
    for (Factor factor : design.factors()) {
      if (factor.name().equals(column)) {
        known = true;
      }
    }
    return known ? "" : "%s is neither a factor nor a column of the stimuli".formatted(text);
  }
}
