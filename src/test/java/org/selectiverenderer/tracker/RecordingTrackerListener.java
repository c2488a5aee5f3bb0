package org.selectiverenderer.tracker;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.selectiverenderer.base.problem.Problem;

/** Hears a tracker in a test, and waits for what is to happen. */
public final class RecordingTrackerListener implements TrackerListener {
  private static final long PATIENCE = 20_000_000_000L;

  public final List<Problem> problems = new CopyOnWriteArrayList<>();
  public final List<Orientation> orientations = new CopyOnWriteArrayList<>();

  /** The places as metres right, up and back, or {@code none}. */
  public final List<String> places = new CopyOnWriteArrayList<>();

  private final AtomicLong samples = new AtomicLong();

  @Override
  public void sample(PoseSample sample) {
    if (samples.incrementAndGet() <= 2_000) {
      places.add(sample.placed() ? sample.x() + " " + sample.y() + " " + sample.z() : "none");
      orientations.add(sample.orientation());
    }
  }

  @Override
  public void problem(Problem problem) {
    problems.add(problem);
  }

  public long samples() {
    return samples.get();
  }

  /** Waits for so many more records. */
  public void more(long records) {
    long wanted = samples() + records;
    until(records + " records", () -> samples() >= wanted);
  }

  /** Waits for a problem that contains a text. */
  public void problem(String text) {
    until(
        "the problem '" + text + "'",
        () -> problems.stream().anyMatch(problem -> problem.message().contains(text)));
  }

  public List<String> messages() {
    return problems.stream().map(Problem::message).toList();
  }

  /** Waits until it is so. */
  public void until(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("waited in vain for " + what + "; problems: " + messages());
      }
      LockSupport.parkNanos(1_000_000);
    }
  }
}
