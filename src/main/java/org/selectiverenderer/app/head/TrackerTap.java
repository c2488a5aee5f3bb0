package org.selectiverenderer.app.head;

import java.io.IOException;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.experiment.headlog.TrackerLog;
import org.selectiverenderer.experiment.headlog.TrackerRecord;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerListener;

/**
 * Takes the records of a tracker to their log, from the moment that it is opened to the moment that
 * it is closed. Records come on the tracker's thread, which must not wait; the rest is called by
 * the thread that steps the world.
 */
public final class TrackerTap implements Consumer<PoseSample>, AutoCloseable {
  private volatile @Nullable TrackerLog log;

  /** What hears a tracker whose records go to a log, and whose problems elsewhere. */
  public static TrackerListener hearing(TrackerTap tap, Consumer<Problem> problem) {
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

  /** A record has arrived. */
  @Override
  public void accept(PoseSample sample) {
    TrackerLog open = log;
    if (open != null) {
      // The record arrived a little before; both clocks are read now and set back by that.
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
   * Begins the log.
   *
   * @param headLog beside which it lies
   * @param tracker as the user named it
   * @param placed whether it tells places of the head, too
   * @throws IOException if it cannot be written
   */
  void open(HeadLogSettings headLog, String tracker, boolean placed, Consumer<Problem> problem)
      throws IOException {
    log =
        TrackerLog.open(
            headLog.file(), headLog.replace(), tracker, placed, System.nanoTime() * 1e-9, problem);
  }

  @Override
  public void close() throws IOException {
    TrackerLog open = log;
    log = null;
    if (open != null) {
      open.close();
    }
  }
}
