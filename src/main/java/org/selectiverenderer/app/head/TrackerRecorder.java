package org.selectiverenderer.app.head;

import java.io.IOException;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.study.headlog.TrackerLogWriter;
import org.selectiverenderer.study.headlog.TrackerRecord;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerListener;

/**
 * Writes the samples of a tracker to their log while the log is open. Samples arrive on the
 * tracker's thread, which must not block; the other methods are called by the thread that steps the
 * world.
 */
public final class TrackerRecorder implements Consumer<PoseSample>, AutoCloseable {
  private volatile @Nullable TrackerLogWriter log;

  /**
   * Returns a tracker listener that passes samples to a recorder and problems to another consumer.
   */
  public static TrackerListener hearing(TrackerRecorder tap, Consumer<Problem> problem) {
    return new TrackerListener() {
      @Override
      public void sample(PoseSample sample) {
        tap.accept(sample);
      }

      @Override
      public void problem(Problem told) {
        problem.accept(told);
      }
    };
  }

  /** Writes a sample that has arrived, if the log is open. */
  @Override
  public void accept(PoseSample sample) {
    TrackerLogWriter open = log;
    if (open != null) {
      // Both clocks are read now and set back by the age of the sample.
      long since = System.nanoTime() - sample.arrival();
      open.add(
          new TrackerRecord(
              sample.number(),
              sample.arrival() * 1e-9,
              Instant.now().minusNanos(since),
              sample.yaw(),
              sample.pitch(),
              sample.roll(),
              sample.placed()
                  ? Optional.of(new TrackerRecord.Place(sample.x(), sample.y(), sample.z()))
                  : Optional.empty()));
    }
  }

  /**
   * Opens the log.
   *
   * @param headLog the head log beside which the tracker log is written
   * @param tracker the tracker's specification as the user wrote it
   * @param placed whether the tracker reports positions of the head, too
   * @throws IOException if it cannot be written
   */
  void open(HeadLogSettings headLog, String tracker, boolean placed, Consumer<Problem> problem)
      throws IOException {
    log =
        TrackerLogWriter.open(
            headLog.file(), headLog.replace(), tracker, placed, System.nanoTime() * 1e-9, problem);
  }

  @Override
  public void close() throws IOException {
    TrackerLogWriter open = log;
    log = null;
    if (open != null) {
      open.close();
    }
  }
}
