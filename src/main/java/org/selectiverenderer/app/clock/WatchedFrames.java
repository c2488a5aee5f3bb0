package org.selectiverenderer.app.clock;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The frames of a schedule as fast as the clock on the wall goes. All are stepped: of those that a
 * slow picture holds up only the last is seen.
 */
final class WatchedFrames implements FrameClock {
  private final FrameSchedule schedule;
  private final OptionalDouble duration;
  private long next;

  /**
   * @param duration seconds after which it is over; empty for the end of the schedule
   */
  WatchedFrames(FrameSchedule schedule, OptionalDouble duration) {
    this.schedule = schedule;
    this.duration = duration;
  }

  @Override
  public List<Double> due(double elapsed) {
    List<Double> due = new ArrayList<>();
    double start = schedule.time(0);
    while (schedule.has(next) && schedule.time(next) - start <= elapsed) {
      due.add(schedule.time(next++));
    }
    return due;
  }

  @Override
  public boolean over(double elapsed) {
    return duration.isPresent() ? elapsed >= duration.getAsDouble() : !schedule.has(next);
  }
}
