package org.selectiverenderer.app.timeline;

import org.selectiverenderer.control.ControlEvent;

/** A line of the time line. */
public sealed interface TimelineEvent {
  /** Seconds of the walk, at the frame of the event. */
  double t();

  /**
   * What the controller told. Its own time is the browser's.
   *
   * @param t seconds of the walk
   */
  record Told(double t, ControlEvent event) implements TimelineEvent {}

  /**
   * Something became of the headset.
   *
   * @param what in one word, such as {@code away}
   */
  record Headset(double t, String what) implements TimelineEvent {}

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
