package org.selectiverenderer.tracker.report;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.LatencyHistogram;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

/**
 * Monitors a tracker for a while: polls it at the frame rate of a display, passes every record to
 * the outputs, and computes statistics.
 */
public final class TrackSession {
  /** Frame rate of the simulated display, per second. */
  public static final int FRAME_RATE = 60;

  /** Number of frames between two status lines. */
  private static final int FRAMES_PER_STATUS = FRAME_RATE / 4;

  private final TrackerSpec spec;
  private final TrackerOptions options;
  private final Consumer<Problem> problems;
  private final List<TrackOutput> outputs;
  private final PoseSampleQueue queue = new PoseSampleQueue();
  private final LatencyHistogram age = new LatencyHistogram();
  private final TrackStatistics.Intervals intervals = new TrackStatistics.Intervals();
  private final CountDownLatch stopping = new CountDownLatch(1);
  private final PoseSample newest = new PoseSample();
  private final PoseSample taken = new PoseSample();

  /**
   * @param problems receives problems on the tracker's thread
   */
  public TrackSession(
      TrackerSpec spec,
      TrackerOptions options,
      Consumer<Problem> problems,
      List<TrackOutput> outputs) {
    this.spec = spec;
    this.options = options;
    this.problems = problems;
    this.outputs = List.copyOf(outputs);
  }

  /** Ends {@link #run} soon; thread-safe. */
  public void stop() {
    stopping.countDown();
  }

  /**
   * Opens the tracker and monitors it until the time is over, {@link #stop} is called or a
   * recording has ended.
   *
   * @param seconds duration; infinite to run until stopped
   * @throws IOException if the tracker cannot be opened or an output cannot be written
   */
  public TrackStatistics run(double seconds) throws IOException {
    long begin = System.nanoTime();
    HeadTracker tracker = TrackerFactory.open(spec, options, listener());
    try (tracker) {
      for (TrackOutput output : outputs) {
        output.begin(tracker.placed());
      }
      watch(tracker, begin, seconds);
    }
    drain(begin);
    TrackStatistics figures = intervals.figures(tracker.health(), queue.lost(), age);
    for (TrackOutput output : outputs) {
      output.end(figures);
    }
    return figures;
  }

  private TrackerListener listener() {
    return new TrackerListener() {
      @Override
      public void sample(PoseSample sample) {
        queue.add(sample);
      }

      @Override
      public void problem(Problem problem) {
        problems.accept(problem);
      }
    };
  }

  private void watch(HeadTracker tracker, long begin, double seconds) throws IOException {
    long period = TimeUnit.SECONDS.toNanos(1) / FRAME_RATE;
    long drawn = 0;
    boolean over = false;
    for (long frame = 1; !over; frame++) {
      over = stopped(begin + frame * period);
      long now = System.nanoTime();
      if (tracker.read(newest) && newest.number() > drawn) {
        drawn = newest.number();
        age.record(now - newest.arrival());
      }
      State state = tracker.health().state();
      drain(begin);
      double time = (now - begin) * 1e-9;
      if (frame % FRAMES_PER_STATUS == 0) {
        for (TrackOutput output : outputs) {
          output.status(time, newest, tracker.health());
        }
      }
      over |= time >= seconds || state == State.ENDED;
    }
  }

  private void drain(long begin) throws IOException {
    while (queue.take(taken)) {
      intervals.add(taken.arrival());
      double time = (taken.arrival() - begin) * 1e-9;
      for (TrackOutput output : outputs) {
        output.sample(time, taken);
      }
    }
    for (TrackOutput output : outputs) {
      output.flush();
    }
  }

  /** Waits for the time of a frame; returns whether the session is to end instead. */
  private boolean stopped(long until) {
    try {
      return stopping.await(until - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return true;
    }
  }

  /**
   * A lock-free ring buffer that passes records from the tracker's thread to the writing thread.
   * While it is full, new records are dropped and counted; the tracker never waits.
   */
  private static final class PoseSampleQueue {
    private static final int SIZE = 1 << 14;

    private final PoseSample[] ring = new PoseSample[SIZE];
    private final AtomicLong written = new AtomicLong();
    private final AtomicLong read = new AtomicLong();
    private final AtomicLong lost = new AtomicLong();

    PoseSampleQueue() {
      for (int i = 0; i < SIZE; i++) {
        ring[i] = new PoseSample();
      }
    }

    /** Adds a copy of a record; called by one thread. */
    void add(PoseSample sample) {
      long at = written.get();
      if (at - read.get() == SIZE) {
        lost.incrementAndGet();
        return;
      }
      ring[(int) (at % SIZE)].set(sample);
      written.set(at + 1);
    }

    /** Takes the oldest record; returns false if there is none; called by one thread. */
    boolean take(PoseSample into) {
      long at = read.get();
      if (at == written.get()) {
        return false;
      }
      into.set(ring[(int) (at % SIZE)]);
      read.set(at + 1);
      return true;
    }

    /** Returns the number of dropped records. */
    long lost() {
      return lost.get();
    }
  }
}
