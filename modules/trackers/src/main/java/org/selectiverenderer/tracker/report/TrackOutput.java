package org.selectiverenderer.tracker.report;

import java.io.IOException;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;

/** An output of the command {@code track}. Called by one thread. */
public interface TrackOutput {
  /**
   * The tracker was opened.
   *
   * @param placed whether it measures positions
   */
  default void begin(boolean placed) throws IOException {}

  /**
   * A record arrived.
   *
   * @param time time of arrival in seconds since the tracker was opened
   */
  default void sample(double time, PoseSample sample) throws IOException {}

  /**
   * Reports the status, four times per second.
   *
   * @param newest the latest pose; its number is 0 before the first
   */
  default void status(double time, PoseSample newest, TrackerHealth health) throws IOException {}

  /** Flushes the output; called once per frame. */
  default void flush() throws IOException {}

  /** Ends the output with the statistics. */
  default void end(TrackStatistics figures) throws IOException {}
}
