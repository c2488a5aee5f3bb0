package org.selectiverenderer.tracker.replay;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;

/** Plays a recording in real time, from its first row. */
public final class ReplaySource implements PoseSource {
  private static final long PATIENCE = TimeUnit.MILLISECONDS.toNanos(PoseSink.PATIENCE_MS);

  private final ReplayLog log;

  public ReplaySource(ReplayLog log) {
    this.log = log;
  }

  /** Does nothing: the recording has been read. */
  @Override
  public void open() {}

  @Override
  public void read(PoseSink intake) {
    intake.connected();
    PoseSample pose = new PoseSample();
    long begin = System.nanoTime();
    for (int row = 0; row < log.size() && !intake.closed(); row++) {
      long due = begin + (long) ((log.time(row) - log.time(0)) * 1e9);
      long left = due - System.nanoTime();
      while (left > 0 && !intake.closed()) {
        LockSupport.parkNanos(Math.min(left, PATIENCE));
        intake.tick();
        left = due - System.nanoTime();
      }
      log.pose(row, pose);
      if (pose.placed()) {
        intake.place(pose.x(), pose.y(), pose.z());
      } else {
        intake.place(Double.NaN, Double.NaN, Double.NaN);
      }
      intake.angles(System.nanoTime(), pose.yaw(), pose.pitch(), pose.roll());
    }
  }

  @Override
  public boolean placed() {
    return log.placed();
  }

  /** Does nothing: there is no connection. */
  @Override
  public void close() {}
}
