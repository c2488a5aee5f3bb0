package org.selectiverenderer.walkthrough.timeline;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.control.ControlEvent;

/** An event of the time line. */
public sealed interface TimelineEvent {
  /** Returns the time of the event's frame, in seconds since the start of the walkthrough. */
  double t();

  /**
   * An event of the selective controller; the event's own time is the browser's.
   *
   * @param t seconds since the start of the walkthrough
   */
  record ControllerEvent(double t, ControlEvent event) implements TimelineEvent {}

  /**
   * An event of the headset.
   *
   * @param what kind of the event, such as {@code away}
   */
  record Headset(double t, String what) implements TimelineEvent {}

  /**
   * The end of the walkthrough.
   *
   * @param frames number of frames stepped
   * @param polygons polygons of the whole scene with its current versions, visible or not
   * @param waiting the choices that were wanted and could not be shown unseen: versions by the
   *     Switches' names, levels by the fields', such as {@code Wood.url}
   * @param qualities how long fields had which levels, for each quality that has fields
   */
  record End(
      double t,
      long frames,
      PolygonSpan polygons,
      Map<String, Integer> waiting,
      List<QualityLevels> qualities)
      implements TimelineEvent {
    /** Creates the end of a walkthrough without fields in which no choice waits. */
    public End(double t, long frames, PolygonSpan polygons) {
      this(t, frames, polygons, Map.of(), List.of());
    }
  }

  /**
   * The number of polygons at the first frame, at the last frame, and the maximum over all frames.
   */
  record PolygonSpan(long start, long end, long max) {}
}
