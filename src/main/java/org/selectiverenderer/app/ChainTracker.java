package org.selectiverenderer.app;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.Trackers;
import org.selectiverenderer.x3d.Problem;

/**
 * The head tracker of several runs, opened by the first and kept: the heading that was reset in one
 * holds in the next, and no device starts anew between two areas. Whoever runs hears its problems.
 * Belongs to the thread that opens runs; problems come from the tracker's.
 */
final class ChainTracker implements AutoCloseable {
  private @Nullable HeadTracker tracker;
  private volatile @Nullable RunListener listener;

  /**
   * The tracker for a run, which may close what it gets: the device stays open.
   *
   * @param settings of which the tracker and its options are the same for all runs
   * @param hears about the tracker until the next run asks
   * @throws IOException when it cannot be used
   */
  HeadTracker lend(HeadSettings settings, RunListener hears) throws IOException {
    listener = hears;
    HeadTracker open = tracker;
    if (open == null) {
      open = Trackers.open(settings.tracker(), settings.options(), new Told());
      tracker = open;
    }
    return new Lent(open);
  }

  @Override
  public void close() {
    if (tracker != null) {
      tracker.close();
    }
  }

  private final class Told implements TrackerListener {
    @Override
    public void problem(Problem problem) {
      RunListener hears = listener;
      if (hears != null) {
        hears.problem(problem);
      }
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
    public TrackerHealth health() {
      return open.health();
    }

    @Override
    public void close() {
      // The chain's to close.
    }
  }
}
