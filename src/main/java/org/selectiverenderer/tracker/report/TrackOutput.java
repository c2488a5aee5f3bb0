package org.selectiverenderer.tracker.report;

import java.io.IOException;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;

/** Where records go. Called by one thread. */
public interface TrackOutput {
  /**
   * The tracker is open.
   *
   * @param placed whether it tells the place of the head, too
   */
  default void begin(boolean placed) throws IOException {}

  /**
   * A record.
   *
   * @param time of its arrival, in seconds since the tracker was opened
   */
  default void sample(double time, PoseSample sample) throws IOException {}

  /**
   * How it goes, four times per second.
   *
   * @param newest the newest pose; its number is 0 before the first
   */
  default void status(double time, PoseSample newest, TrackerHealth health) throws IOException {}

  /** What was written since the last call should reach its readers now; once per frame. */
  default void flush() throws IOException {}

  /** The end. */
  default void end(TrackFigures figures) throws IOException {}
}
