package org.selectiverenderer.app;

import java.util.List;
import java.util.Map;

/** A line of the time line. Times are seconds of the walk-through, at the frame of the event. */
public sealed interface TimelineEvent {
  /**
   * The scene as loaded, the condition applied.
   *
   * @param switches the choice of each enriched Switch by name, in the order of the scene
   */
  record Start(double t, Map<String, Integer> switches) implements TimelineEvent {}

  /** The viewer entered an area. */
  record Enter(double t, String sensor, List<String> schemas) implements TimelineEvent {}

  /** The viewer left an area. */
  record Exit(double t, String sensor, List<String> schemas) implements TimelineEvent {}

  /** A Switch shows another version. */
  record Switched(double t, String name, int from, int to, String schema)
      implements TimelineEvent {}

  /**
   * The walk is over.
   *
   * @param frames stepped
   * @param polygons of the whole scene in its present versions, seen or not
   */
  record End(double t, long frames, PolygonSpan polygons) implements TimelineEvent {}

  /** Polygons at the first frame, at the last one, and the most in any frame. */
  record PolygonSpan(long start, long end, long max) {}
}
