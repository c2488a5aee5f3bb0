package org.selectiverenderer.study.web;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.study.web.ExposureReplay.Seen;
import org.selectiverenderer.study.web.WebExposureLog.SceneEvent;

/**
 * Tells what areas and objects did in an exposure as journals have it, which is the time line of
 * {@code run}: how the Switches are at the begin, then what changes. Which schema a change comes
 * from, the page does not tell.
 */
final class SceneEventMembers {
  private final WebExposureLog log;
  private final List<Seen> seen;
  private final Map<String, Integer> choices = new HashMap<>();
  private int frame;

  private SceneEventMembers(WebExposureLog log, List<Seen> seen) {
    this.log = log;
    this.seen = seen;
  }

  /**
   * Returns the events, each with its time {@code t}.
   *
   * @param seen what a replay found in each frame; may be empty
   */
  static List<Map<String, Object>> of(WebExposureLog log, List<Seen> seen) {
    return new SceneEventMembers(log, seen).all();
  }

  private List<Map<String, Object>> all() {
    List<Map<String, Object>> events = new ArrayList<>();
    Map<String, Object> start = new LinkedHashMap<>();
    start.put("t", 0.0);
    start.put("event", "start");
    Map<String, Integer> switches = new LinkedHashMap<>();
    start.put("switches", switches);
    events.add(start);
    for (SceneEvent event : log.events()) {
      if (event.kind() == SceneEvent.Kind.SWITCH) {
        Integer before = choices.put(event.node(), event.choice());
        if (before == null && event.t() == 0) {
          switches.put(event.node(), event.choice()); // The page tells each object at the begin.
        } else {
          events.add(changed(event, before == null ? -1 : before));
        }
      } else {
        events.add(moved(event));
      }
    }
    return events;
  }

  private static Map<String, Object> changed(SceneEvent event, int before) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("t", DecimalRounding.to(6, event.t()));
    members.put("event", "switch");
    members.put("switch", event.node());
    members.put("from", before);
    members.put("to", event.choice());
    return members;
  }

  private Map<String, Object> moved(SceneEvent event) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("t", DecimalRounding.to(6, event.t()));
    members.put("event", event.kind() == SceneEvent.Kind.ENTER ? "enter" : "exit");
    members.put("sensor", event.node());
    members.put("schemas", schemas(event.t()));
    return members;
  }

  /** Returns the schemas that are active in the first frame from a time on; times never go back. */
  private List<String> schemas(double t) {
    while (frame < seen.size() - 1 && log.frames().get(frame).t() < t) {
      frame++;
    }
    return seen.isEmpty() ? List.of() : seen.get(frame).schemas();
  }
}
