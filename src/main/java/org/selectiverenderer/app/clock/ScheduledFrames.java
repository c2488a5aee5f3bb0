package org.selectiverenderer.app.clock;

import java.util.List;

/**
 * A frame clock that takes one frame of a schedule for each picture, however long a picture takes.
 */
final class ScheduledFrames implements FrameClock {
  private final FrameSchedule schedule;
  private long next;

  ScheduledFrames(FrameSchedule schedule) {
    this.schedule = schedule;
  }

  @Override
  public List<Double> due(double elapsed) {
    return List.of(schedule.time(next++));
  }

  @Override
  public boolean over(double elapsed) {
    return !schedule.has(next);
  }
}
