package org.selectiverenderer.tracker.replay;

import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.pipeline.PoseFilter;
import org.selectiverenderer.tracker.pipeline.PublishingTracker;

/**
 * Plays a recording by the clock of the frames: the same times give the same poses, whatever the
 * wall-clock time. {@link #advanceTo} is called by one thread.
 */
public final class FrameSteppedReplay extends PublishingTracker {
  private final ReplayLog log;
  private final TrackerOptions options;
  private final PoseSample sample = new PoseSample();
  private PoseFilter filter;
  private volatile int next;
  private volatile boolean closed;

  public FrameSteppedReplay(TrackerSpec.Replay spec, ReplayLog log, TrackerOptions options) {
    super(spec);
    this.log = log;
    this.options = options;
    filter = PoseFilter.of(options);
  }

  /**
   * Publishes the last row up to a time. An earlier time than before restarts from the beginning.
   *
   * @param time time of the recording in seconds
   */
  public void advanceTo(double time) {
    int row = next;
    if (row > 0 && log.time(row - 1) > time) {
      row = 0;
      filter = PoseFilter.of(options);
    }
    int before = row;
    while (row < log.size() && log.time(row) <= time) {
      log.pose(row, sample);
      // Filters run by the clock of the recording.
      long recorded = (long) (log.time(row) * 1e9);
      sample.set(row + 1L, recorded, sample.yaw(), sample.pitch(), sample.roll());
      filter.apply(sample);
      row++;
    }
    if (row > before) {
      sample.set(row, System.nanoTime(), sample.yaw(), sample.pitch(), sample.roll());
      publish(sample);
    }
    next = row;
  }

  @Override
  public boolean placed() {
    return log.placed();
  }

  @Override
  public TrackerHealth health() {
    int row = next;
    double span = row < 2 ? 0 : log.time(row - 1) - log.time(0);
    State state =
        closed
            ? State.CLOSED
            : row == 0 ? State.CONNECTING : row < log.size() ? State.STREAMING : State.ENDED;
    return new TrackerHealth(state, row, span > 0 ? (row - 1) / span : 0, 0, 0, 0, 0, 0);
  }

  @Override
  public void close() {
    closed = true;
  }
}
