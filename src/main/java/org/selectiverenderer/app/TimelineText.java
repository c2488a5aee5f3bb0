package org.selectiverenderer.app;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The time line for people. */
public final class TimelineText {
  /** Switches listed one by one at the start; of more, only the number is told. */
  private static final int LISTED = 20;

  /** One line, without its end. */
  public String line(TimelineEvent event) {
    if (event instanceof TimelineEvent.Start start) {
      return row(start.t(), "start", switches(start.switches()));
    }
    if (event instanceof TimelineEvent.Enter enter) {
      return row(enter.t(), "enter", area(enter.sensor(), enter.schemas()));
    }
    if (event instanceof TimelineEvent.Exit exit) {
      return row(exit.t(), "exit", area(exit.sensor(), exit.schemas()));
    }
    if (event instanceof TimelineEvent.Switched s) {
      return row(
          s.t(),
          "switch",
          "%s: choice %s -> %s (%s)".formatted(s.name(), s.from(), s.to(), s.schema()));
    }
    TimelineEvent.End end = (TimelineEvent.End) event;
    return row(
        end.t(),
        "end",
        String.format(
            Locale.ROOT,
            "%d frames; %d polygons at the start, %d at the end, %d at most",
            end.frames(),
            end.polygons().start(),
            end.polygons().end(),
            end.polygons().max()));
  }

  private static String row(double t, String event, String text) {
    return String.format(Locale.ROOT, "%8.3f s  %-6s  %s", t, event, text);
  }

  private static String area(String sensor, List<String> schemas) {
    return schemas.isEmpty()
        ? sensor + " (activates no schema)"
        : sensor + " activates " + String.join(", ", schemas);
  }

  private static String switches(Map<String, Integer> switches) {
    if (switches.isEmpty()) {
      return "no Switch of the scene has metadata of a schema: nothing will change";
    }
    if (switches.size() > LISTED) {
      return switches.size() + " enriched switches";
    }
    return switches.entrySet().stream()
        .map(entry -> entry.getKey() + ": choice " + entry.getValue())
        .collect(Collectors.joining(", "));
  }
}
