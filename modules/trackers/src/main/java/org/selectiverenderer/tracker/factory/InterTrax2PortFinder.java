package org.selectiverenderer.tracker.factory;

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
import org.selectiverenderer.tracker.pipeline.LiveTracker;
import org.selectiverenderer.tracker.serial.InterTrax2Source;
import org.selectiverenderer.tracker.serial.SerialPorts;

/**
 * Finds the serial port with an InterTrax2 ({@code intertrax2:auto}): all ports are tried in
 * parallel, and the first that sends records is chosen. Other devices on serial ports receive the
 * commands of an InterTrax2, too.
 */
public final class InterTrax2PortFinder {
  /** Timeout in milliseconds, which allows for all resets of the handshake with a hung device. */
  private static final long PATIENCE_MS = 6000;

  private InterTrax2PortFinder() {}

  /**
   * Resolves a SPEC.
   *
   * @return the same SPEC if it names its port; empty if the port is to be searched and no device
   *     answers
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static Optional<TrackerSpec> found(TrackerSpec spec) throws InterruptedException {
    return spec instanceof TrackerSpec.InterTrax2 serial && serial.searched()
        ? among(SerialPorts.names(), PATIENCE_MS)
        : Optional.of(spec);
  }

  /** Returns the first of some ports with a device that answers in time. */
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
          // A port that is in use, or not permitted, is skipped.
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
        // Ports without the device report problems, which are ignored.
      }
    };
  }
}
