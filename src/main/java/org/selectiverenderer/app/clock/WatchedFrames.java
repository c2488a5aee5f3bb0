package org.selectiverenderer.app.clock;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A frame clock that takes the frames of a schedule in real time. All frames are stepped; of the
 * frames that become due during one slow picture only the last is drawn.
 */
final class WatchedFrames implements FrameClock {
  private final FrameSchedule schedule;
  private final OptionalDouble duration;
  private long next;

  /**
   * @param duration seconds after which the clock is over; empty for the end of the schedule
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
