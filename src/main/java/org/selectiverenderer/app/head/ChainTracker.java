package org.selectiverenderer.app.head;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.open.Trackers;

/**
 * The head tracker of several runs, opened by the first and kept: the heading that was reset in one
 * holds in the next, and no device starts anew between two areas. Whoever runs hears its problems.
 * Belongs to the thread that opens runs; problems come from the tracker's.
 */
public final class ChainTracker implements AutoCloseable {
  private final Opener opener;
  private @Nullable HeadTracker tracker;
  private final CountDownLatch heard = new CountDownLatch(1);
  private volatile Consumer<Problem> listener = problem -> {};
  private volatile Consumer<PoseSample> taker = sample -> {};

  /** Opens the tracker of a chain. */
  @FunctionalInterface
  public interface Opener {
    /**
     * Opens it.
     *
     * @param hears its records and problems
     * @throws IOException when it cannot be used
     */
    HeadTracker open(TrackerSettings settings, TrackerListener hears) throws IOException;
  }

  /** Of whatever tracker the settings name. */
  public ChainTracker() {
    this((settings, hears) -> Trackers.open(settings.spec(), settings.options(), hears));
  }

  /** Of one that is opened in another way. */
  public ChainTracker(Opener opener) {
    this.opener = opener;
  }

  /**
   * The tracker for a run, which may close what it gets: the device stays open.
   *
   * @param settings the same for all runs
   * @param hears what is wrong with the tracker until the next run asks
   * @param takes each record until then, on the tracker's thread
   * @throws IOException when it cannot be used
   */
  public HeadTracker lend(
      TrackerSettings settings, Consumer<Problem> hears, Consumer<PoseSample> takes)
      throws IOException {
    listener = hears;
    taker = takes;
    HeadTracker open = tracker;
    if (open == null) {
      open = opener.open(settings, new Told());
      tracker = open;
    }
    return new Lent(open);
  }

  /**
   * Opens the tracker, unless it is open, and waits for its first record.
   *
   * @param settings the same for all runs
   * @param patience milliseconds to wait
   * @throws TrackerException when it cannot be used, or nothing comes in that time
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public void awaitRecord(TrackerSettings settings, long patience)
      throws IOException, InterruptedException {
    // What is wrong with it in the meantime is in the one line that follows.
    try (HeadTracker lent = lend(settings, problem -> {}, sample -> {})) {
      if (settings.tracked() && !heard.await(patience, TimeUnit.MILLISECONDS)) {
        throw new TrackerException(
            "the tracker %s sent no record within %s s"
                .formatted(lent.spec(), DecimalText.rounded(patience / 1000.0, 1)));
      }
    }
  }

  @Override
  public void close() {
    if (tracker != null) {
      tracker.close();
    }
  }

  private final class Told implements TrackerListener {
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

  private record Lent(HeadTracker open) implements HeadTracker {
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
      // The chain's to close.
    }
  }
}
