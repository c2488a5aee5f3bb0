package org.selectiverenderer.tracker.factory;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.net.OpenTrackSource;
import org.selectiverenderer.tracker.net.TcpLinesSource;
import org.selectiverenderer.tracker.net.VrpnSource;
import org.selectiverenderer.tracker.pipeline.LiveTracker;
import org.selectiverenderer.tracker.pipeline.PoseSource;
import org.selectiverenderer.tracker.replay.ReplayLog;
import org.selectiverenderer.tracker.replay.ReplaySource;
import org.selectiverenderer.tracker.serial.FastrakSource;
import org.selectiverenderer.tracker.serial.InterTrax2Source;
import org.selectiverenderer.tracker.serial.SerialPorts;

/** Opens trackers of every kind, by their SPEC. */
public final class TrackerFactory {
  private TrackerFactory() {}

  /**
   * Opens a tracker and starts reading it.
   *
   * @param listener receives problems and records on the tracker's thread
   * @return the tracker, which the caller must close
   * @throws TrackerException if the tracker cannot be opened: no such port, permission denied, port
   *     in use, no server, a log that cannot be read. A device that does not answer is reported to
   *     the listener, and tried again until it does
   */
  public static HeadTracker open(TrackerSpec spec, TrackerOptions options, TrackerListener listener)
      throws TrackerException {
    if (spec instanceof TrackerSpec.None) {
      return new NullTracker();
    }
    if (spec instanceof TrackerSpec.InterTrax2 serial && serial.searched()) {
      return open(searched(spec), options, listener);
    }
    return LiveTracker.open(spec, source(spec, listener), options, listener);
  }

  private static TrackerSpec searched(TrackerSpec spec) throws TrackerException {
    try {
      return InterTrax2PortFinder.found(spec)
          .orElseThrow(
              () ->
                  new TrackerException(
                      "no InterTrax2 answers at a serial port (%s); plug one in, or name its port"
                          .formatted(
                              SerialPorts.names().isEmpty()
                                  ? "there is none"
                                  : String.join(", ", SerialPorts.names()))));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new TrackerException("interrupted while looking for an InterTrax2", e);
    }
  }

  private static PoseSource source(TrackerSpec spec, TrackerListener listener)
      throws TrackerException {
    if (spec instanceof TrackerSpec.InterTrax2 serial) {
      return new InterTrax2Source(serial.port());
    } else if (spec instanceof TrackerSpec.Fastrak serial) {
      return new FastrakSource(serial.port(), serial.baud());
    } else if (spec instanceof TrackerSpec.OpenTrack udp) {
      return new OpenTrackSource(udp.host(), udp.port());
    } else if (spec instanceof TrackerSpec.Vrpn vrpn) {
      return new VrpnSource(vrpn.tracker(), vrpn.host(), vrpn.port());
    } else if (spec instanceof TrackerSpec.Tcp tcp) {
      return new TcpLinesSource(tcp.host(), tcp.port());
    } else if (spec instanceof TrackerSpec.Replay replay) {
      return new ReplaySource(log(replay.file(), listener));
    }
    throw new IllegalArgumentException("no source for " + spec);
  }

  private static ReplayLog log(Path file, TrackerListener listener) throws TrackerException {
    try {
      return ReplayLog.read(file, new ProblemCollector(listener::problem))
          .orElseThrow(() -> new TrackerException("the log " + file + " has errors"));
    } catch (TrackerException e) {
      throw e;
    } catch (NoSuchFileException e) {
      throw new TrackerException("there is no log " + file, e);
    } catch (IOException e) {
      throw new TrackerException("the log " + file + " cannot be read: " + e.getMessage(), e);
    }
  }

  /** The null object for {@code none}: a tracker that never has a pose or a problem. */
  private static final class NullTracker implements HeadTracker {
    @Override
    public TrackerSpec spec() {
      return new TrackerSpec.None();
    }

    @Override
    public boolean read(PoseSample into) {
      return false;
    }

    @Override
    public void resetHeading() {}

    @Override
    public TrackerHealth health() {
      return new TrackerHealth(TrackerHealth.State.NONE, 0, 0, 0, 0, 0, 0, 0);
    }

    @Override
    public void close() {}
  }
}
