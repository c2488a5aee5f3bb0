package org.selectiverenderer.walkthrough.timeline;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.control.ChoiceCause;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SwitchVisibility;

/** Writes the time line as text for people. */
public final class TimelineText {
  /** The largest number of switches that are listed one by one at the start. */
  private static final int LISTED = 20;

  private final boolean sights;

  /** Creates a writer that leaves out what the viewer sees of changes. */
  public TimelineText() {
    this(false);
  }

  /**
   * Creates a writer.
   *
   * @param sights whether it tells what the viewer sees of changes, where that is known
   */
  public TimelineText(boolean sights) {
    this.sights = sights;
  }

  /** Returns the line of an event, without a line feed. */
  public String line(TimelineEvent event) {
    if (event instanceof TimelineEvent.ControllerEvent told) {
      return line(told.t(), told.event());
    }
    if (event instanceof TimelineEvent.Headset headset) {
      return row(headset.t(), "headset", headset.what());
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
                end.polygons().max())
            + waiting(end.waiting())
            + end.qualities().stream()
                .map(quality -> "; " + levels(quality))
                .collect(Collectors.joining()));
  }

  private static String levels(QualityLevels quality) {
    StringBuilder text = new StringBuilder(quality.quality().spelling());
    text.append(" of ").append(Pluralizer.of(quality.fields(), "field"));
    boolean first = true;
    for (QualityLevels.Level level : quality.levels()) {
      text.append(first ? ": " : ", ");
      text.append(level.level() < 0 ? "no level" : "level " + level.level());
      if (quality.seconds() > 0) {
        text.append(
            String.format(Locale.ROOT, " for %.0f %%", 100 * level.seconds() / quality.seconds()));
        text.append(first ? " of the time" : "");
      }
      text.append(" (").append(Pluralizer.of(level.end(), "field"));
      text.append(first ? " at the end)" : ")");
      first = false;
    }
    return text.toString();
  }

  private String line(double t, ControlEvent event) {
    if (event instanceof ControlEvent.Start start) {
      return row(t, "start", start(start));
    }
    if (event instanceof ControlEvent.Enter enter) {
      return row(t, "enter", area(enter.sensor(), enter.schemas()));
    }
    if (event instanceof ControlEvent.Exit exit) {
      return row(t, "exit", area(exit.sensor(), exit.schemas()));
    }
    if (event instanceof ControlEvent.FieldChange f) {
      return row(
          t,
          "field",
          "%s: %s of %s level %s -> %s%s%s"
              .formatted(
                  f.object(),
                  f.quality().spelling(),
                  f.field(),
                  f.from(),
                  f.to(),
                  by(f.schema()),
                  sight(f.seen())));
    }
    ControlEvent.SwitchChange s = (ControlEvent.SwitchChange) event;
    return row(
        t,
        "switch",
        "%s: choice %s -> %s%s%s"
            .formatted(s.switchName(), s.from(), s.to(), by(s.cause()), sight(s.seen())));
  }

  private String sight(Optional<SwitchVisibility> seen) {
    return sights ? seen.map(TimelineText::sight).orElse("") : "";
  }

  private static String sight(SwitchVisibility seen) {
    return seen.visible()
        ? String.format(
            Locale.ROOT, ", %.0f pixels seen, %.0f degrees/s", seen.pixels(), seen.turning())
        : ", not seen";
  }

  private static String waiting(Map<String, Integer> choices) {
    return choices.isEmpty() ? "" : "; not shown, as it would have been seen: " + listed(choices);
  }

  private static String by(ChoiceCause cause) {
    return cause.budget() ? " (budget)" : by(cause.schema());
  }

  private static String by(String schema) {
    return schema.isEmpty() ? "" : " (" + schema + ")";
  }

  private static String row(double t, String event, String text) {
    return String.format(Locale.ROOT, "%8.3f s  %-6s  %s", t, event, text);
  }

  private static String area(String sensor, List<String> schemas) {
    return schemas.isEmpty()
        ? sensor + " (activates no schema)"
        : sensor + " activates " + String.join(", ", schemas);
  }

  private static String start(ControlEvent.Start start) {
    if (start.fields().isEmpty()) {
      return switches(start.switches());
    }
    int fields = start.fields().values().stream().mapToInt(Map::size).sum();
    String what = Pluralizer.of(fields, "field") + " with levels";
    return start.switches().isEmpty() ? what : switches(start.switches()) + "; " + what;
  }

  private static String switches(Map<String, Integer> switches) {
    if (switches.isEmpty()) {
      return "no Switch of the scene has schema metadata, so nothing will change";
    }
    if (switches.size() > LISTED) {
      return switches.size() + " enriched switches";
    }
    return listed(switches);
  }

  private static String listed(Map<String, Integer> choices) {
    return choices.entrySet().stream()
        .map(entry -> entry.getKey() + ": choice " + entry.getValue())
        .collect(Collectors.joining(", "));
  }
}
