package org.selectiverenderer.app.head;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

/**
 * A head tracker that the runs of a session share: the first run opens it and it stays open, so
 * that a heading that was reset in one run holds in the next, and no device restarts between two
 * areas. The current run receives its problems. The class is confined to the thread that opens
 * runs; problems arrive on the tracker's thread.
 */
public final class SharedHeadTracker implements AutoCloseable {
  private final Opener opener;
  private @Nullable HeadTracker tracker;
  private final CountDownLatch heard = new CountDownLatch(1);
  private volatile Consumer<Problem> listener = problem -> {};
  private volatile Consumer<PoseSample> taker = sample -> {};

  /** Opens the shared tracker. */
  @FunctionalInterface
  public interface Opener {
    /**
     * Opens the tracker.
     *
     * @param hears receives the samples and problems of the tracker
     * @throws IOException when it cannot be used
     */
    HeadTracker open(TrackerSettings settings, TrackerListener hears) throws IOException;
  }

  /** Creates a shared tracker that opens the device named by the settings. */
  public SharedHeadTracker() {
    this((settings, hears) -> TrackerFactory.open(settings.spec(), settings.options(), hears));
  }

  /** Creates a shared tracker with another way to open its device. */
  public SharedHeadTracker(Opener opener) {
    this.opener = opener;
  }

  /**
   * Returns the tracker for a run. The run may close the returned object; the device stays open.
   *
   * @param settings the same for all runs
   * @param hears receives the problems of the tracker until the next run borrows it
   * @param takes receives each sample until then, on the tracker's thread
   * @throws IOException when it cannot be used
   */
  public HeadTracker lend(
      TrackerSettings settings, Consumer<Problem> hears, Consumer<PoseSample> takes)
      throws IOException {
    listener = hears;
    taker = takes;
    HeadTracker open = tracker;
    if (open == null) {
      open = opener.open(settings, new TrackerEvents());
      tracker = open;
    }
    return new LentTracker(open);
  }

  /**
   * Opens the tracker, unless it is open, and waits for its first sample.
   *
   * @param settings the same for all runs
   * @param patience the longest time to wait, in milliseconds
   * @throws TrackerException when it cannot be used, or no sample arrives in that time
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public void awaitRecord(TrackerSettings settings, long patience)
      throws IOException, InterruptedException {
    // Its problems in the meantime are summed up by the exception below.
    try (HeadTracker lent = lend(settings, problem -> {}, sample -> {})) {
      if (settings.tracked() && !heard.await(patience, TimeUnit.MILLISECONDS)) {
        throw new TrackerException(
            "the tracker %s sent no record within %s s"
                .formatted(lent.spec(), DecimalFormatter.rounded(patience / 1000.0, 1)));
      }
    }
  }

  @Override
  public void close() {
    if (tracker != null) {
      tracker.close();
    }
  }

  private final class TrackerEvents implements TrackerListener {
    @Override
    public void sample(PoseSample sample) {
      heard.countDown();
      taker.accept(sample);
    }

    @Override
    public void problem(Problem problem) {
      listener.accept(problem);
    }
  }

  private record LentTracker(HeadTracker open) implements HeadTracker {
    @Override
    public TrackerSpec spec() {
      return open.spec();
    }

    @Override
    public boolean read(PoseSample into) {
      return open.read(into);
    }

    @Override
    public void resetHeading() {
      open.resetHeading();
    }

    @Override
    public boolean placed() {
      return open.placed();
    }

    @Override
    public Optional<String> described() {
      return open.described();
    }

    @Override
    public TrackerHealth health() {
      return open.health();
    }

    @Override
    public void close() {
      // The owner of the shared tracker closes the device.
    }
  }
}
