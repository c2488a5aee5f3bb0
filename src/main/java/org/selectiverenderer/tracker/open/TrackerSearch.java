package org.selectiverenderer.tracker.open;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.live.LiveTracker;
import org.selectiverenderer.tracker.serial.InterTrax2Source;
import org.selectiverenderer.tracker.serial.SerialPorts;

/**
 * Finds the serial port at which an InterTrax2 answers ({@code intertrax2:auto}): all are asked at
 * once, and the first that sends records is it. What else hangs on a serial port is sent the
 * commands of an InterTrax2, too.
 */
public final class TrackerSearch {
  /** A device that hangs answers after all the resets of its handshake; milliseconds. */
  private static final long PATIENCE_MS = 6000;

  private TrackerSearch() {}

  /**
   * The tracker that a SPEC means.
   *
   * @return the same one where it names its place; empty when it is to be found and no port answers
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static Optional<TrackerSpec> found(TrackerSpec spec) throws InterruptedException {
    return spec instanceof TrackerSpec.InterTrax2 serial && serial.searched()
        ? among(SerialPorts.names(), PATIENCE_MS)
        : Optional.of(spec);
  }

  /** The first of some ports that answers in time. */
  static Optional<TrackerSpec> among(List<String> ports, long patienceMs)
      throws InterruptedException {
    BlockingQueue<TrackerSpec> answers = new LinkedBlockingQueue<>();
    List<HeadTracker> open = new ArrayList<>();
    try {
      for (String port : ports) {
        TrackerSpec spec = new TrackerSpec.InterTrax2(port);
        try {
          open.add(
              LiveTracker.open(
                  spec, new InterTrax2Source(port), TrackerOptions.NONE, answer(spec, answers)));
        } catch (TrackerException e) {
          // In use, or not ours: it is not the one.
        }
      }
      return open.isEmpty()
          ? Optional.empty()
          : Optional.ofNullable(answers.poll(patienceMs, TimeUnit.MILLISECONDS));
    } finally {
      open.forEach(HeadTracker::close);
    }
  }

  private static TrackerListener answer(TrackerSpec spec, BlockingQueue<TrackerSpec> answers) {
    return new TrackerListener() {
      @Override
      public void sample(PoseSample sample) {
        answers.add(spec);
      }

      @Override
      public void problem(Problem problem) {
        // That nothing answers at a port is what most of them say.
      }
    };
  }
}
