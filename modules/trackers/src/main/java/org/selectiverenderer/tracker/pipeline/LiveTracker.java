package org.selectiverenderer.tracker.pipeline;

import java.io.IOException;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A tracker with a thread that reads a {@link PoseSource}. After a lost connection the thread tries
 * to reopen it, several times a second, until that succeeds or the tracker is closed.
 */
public final class LiveTracker extends PublishingTracker {
  /** Interval between attempts to reconnect. */
  private static final long RETRY_MS = 100;

  /** The time after which a driver that does not return from reading is left to itself. */
  private static final long CLOSE_MS = 5000;

  private final PoseSource source;
  private final TrackerHealthMonitor meter = new TrackerHealthMonitor();
  private final CountDownLatch closing = new CountDownLatch(1);
  private final TrackerProblemReporter episodes;
  private final TrackerListener listener;
  private final PoseFilter filter;
  private final Thread thread;
  private boolean wasLost;
  private volatile State state = State.CONNECTING;

  private LiveTracker(
      TrackerSpec spec, PoseSource source, TrackerOptions options, TrackerListener listener) {
    super(spec);
    this.source = source;
    this.listener = listener;
    filter = PoseFilter.of(options);
    episodes = new TrackerProblemReporter(spec, listener);
    String text = spec.toString();
    thread = new Thread(this::run, "tracker-" + text.substring(0, text.indexOf(':')));
    thread.setDaemon(true);
  }

  /**
   * Opens a source and starts to read it.
   *
   * @throws TrackerException if it cannot be opened
   */
  public static LiveTracker open(
      TrackerSpec spec, PoseSource source, TrackerOptions options, TrackerListener listener)
      throws TrackerException {
    source.open();
    LiveTracker tracker = new LiveTracker(spec, source, options, listener);
    tracker.thread.start();
    return tracker;
  }

  @Override
  public boolean placed() {
    return source.placed();
  }

  @Override
  public TrackerHealth health() {
    return meter.health(state, System.nanoTime());
  }

  @Override
  public void close() {
    closing.countDown();
    boolean interrupted = false;
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(CLOSE_MS);
    while (thread.isAlive() && System.nanoTime() < end) {
      try {
        thread.join(RETRY_MS);
      } catch (InterruptedException e) {
        interrupted = true; // Restored after the device is closed.
      }
    }
    state = State.CLOSED;
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void run() {
    Reading reading = new Reading();
    try {
      do {
        try {
          source.read(reading);
          if (reading()) {
            state = State.ENDED;
          }
          return;
        } catch (IOException e) {
          lost(e.getMessage());
        } catch (RuntimeException e) {
          lost(failed(e));
        }
      } while (reopened());
    } finally {
      source.close();
    }
  }

  private void lost(String reason) {
    if (!reading() || ShutdownCheck.begun()) {
      return;
    }
    source.close();
    meter.pause();
    wasLost = meter.records() > 0;
    state = wasLost ? State.LOST : State.CONNECTING;
    episodes.lost(reason);
  }

  private boolean reopened() {
    while (pausedAndStillWanted()) {
      try {
        source.open();
        return true;
      } catch (TrackerException e) {
        lost(e.getMessage());
      } catch (RuntimeException e) {
        lost(failed(e)); // A driver may fail while a device is plugged in; retry.
      }
    }
    return false;
  }

  private static String failed(RuntimeException e) {
    return "the tracker's driver failed, please report it (" + e + ")";
  }

  private boolean pausedAndStillWanted() {
    try {
      return !closing.await(RETRY_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      return false; // An interrupt means the end of this thread.
    }
  }

  private boolean reading() {
    return closing.getCount() > 0;
  }

  /** Receives the source's records on the tracker's thread. */
  private final class Reading implements PoseSink {
    private final PoseSample sample = new PoseSample();
    private final RecordRateGuard flood = new RecordRateGuard();
    private long number;
    private long connectedAt = System.nanoTime();

    @Override
    public boolean closed() {
      return !reading();
    }

    @Override
    public void connected() {
      connectedAt = System.nanoTime();
    }

    @Override
    public void angles(long arrival, double yaw, double pitch, double roll) {
      if (sane(yaw) && sane(pitch) && sane(roll)) {
        sample.turn(yaw, pitch, roll);
        take(arrival);
      } else {
        bad();
      }
    }

    @Override
    public void place(double x, double y, double z) {
      // The comparison is false for NaN, too.
      if (x * x + y * y + z * z <= FARTHEST * FARTHEST) {
        sample.place(x, y, z);
      } else {
        sample.unplace();
      }
    }

    /** Returns whether an angle is in range; false for NaN. */
    private boolean sane(double angle) {
      return Math.abs(angle) <= LARGEST_ANGLE;
    }

    @Override
    public void quaternion(long arrival, double x, double y, double z, double w) {
      double length = Math.sqrt(x * x + y * y + z * z + w * w);
      if (Math.abs(length - 1) < 0.1) {
        sample.turn(x / length, y / length, z / length, w / length);
        take(arrival);
      } else {
        bad();
      }
    }

    private void take(long arrival) {
      if (!reading()) {
        return; // A driver that returns after it was left has nobody to tell.
      }
      sample.set(++number, arrival, sample.yaw(), sample.pitch(), sample.roll());
      filter.apply(sample);
      publish(sample);
      if (wasLost) {
        meter.reconnected();
        wasLost = false;
      }
      if (state != State.STREAMING) {
        episodes.streaming(meter.silence(arrival));
        state = State.STREAMING;
      }
      meter.good(arrival);
      if (flood.record(arrival)) {
        episodes.flood();
      }
      listener.sample(sample);
    }

    @Override
    public void bad() {
      meter.bad();
    }

    @Override
    public void tick() {
      long now = System.nanoTime();
      // Only silence since the connection was made counts.
      double silence = Math.min(meter.silence(now), (now - connectedAt) * 1e-9);
      if (state != State.SILENT && silence > TrackerHealth.SILENCE) {
        episodes.silent(meter.badSinceGood());
        meter.pause();
        state = State.SILENT;
      }
    }
  }

  /** Formats a duration for messages. */
  static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.1f s", seconds);
  }

  /**
   * Detects the shutdown of the process, as by Ctrl-C. Libraries then close their devices while
   * trackers still read them, which is not a failure of the device.
   */
  private static final class ShutdownCheck {
    private ShutdownCheck() {}

    /**
     * Returns whether the shutdown has begun. Java has no query for it, but rejects new shutdown
     * hooks.
     */
    static boolean begun() {
      Thread hook = new Thread(() -> {});
      try {
        Runtime.getRuntime().addShutdownHook(hook);
        return !Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        return true;
      }
    }
  }
}
