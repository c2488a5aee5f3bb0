package org.selectiverenderer.browser.nodes.follow;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/**
 * The finite response of chasers (X3D 4.0, 39.3.1): each change of the destination is a transition
 * that lasts {@code duration} seconds, eased at both ends by half a cosine wave. The value is the
 * sum of all transitions, so that a new destination blends with transitions in progress.
 */
final class ChaserResponse implements FollowerResponse {
  /**
   * Largest number of transitions in progress; older ones are completed at once, so that memory is
   * bounded.
   */
  private static final int MOST = 1024;

  private record Way(double[] way, double since) {}

  private final FollowerValueSpace space;
  private final double duration;
  private final Deque<Way> ways = new ArrayDeque<>();
  private double[] base = {};
  private double[] destination = {};
  private double[] value = {};

  ChaserResponse(FollowerValueSpace space, double duration) {
    this.space = space;
    this.duration = duration;
  }

  @Override
  public void start(double[] at) {
    ways.clear();
    base = at;
    value = at;
    destination = at;
  }

  @Override
  public void aim(double[] to, double time) {
    if (to.length != destination.length) {
      refit(to);
    }
    double[] way = space.way(destination, to);
    destination = to;
    if (space.length(way) > 0) {
      ways.add(new Way(way, time));
    }
    if (ways.size() > MOST) {
      base = space.along(base, ways.remove().way, 1);
    }
  }

  /** Adapts to a destination of another length; new elements are at their destination at once. */
  private void refit(double[] to) {
    base = FollowerValueSpace.fitted(base, to);
    value = FollowerValueSpace.fitted(value, to);
    destination = FollowerValueSpace.fitted(destination, to);
    Way[] known = ways.toArray(Way[]::new);
    ways.clear();
    for (Way each : known) {
      ways.add(new Way(Arrays.copyOf(each.way, to.length), each.since));
    }
  }

  @Override
  public void advance(double time) {
    while (!ways.isEmpty() && time - ways.peek().since >= duration) {
      base = space.along(base, ways.remove().way, 1);
    }
    if (ways.isEmpty()) {
      base = destination; // Drops accumulated rounding errors.
    }
    double[] sum = base;
    for (Way way : ways) {
      double share = 0.5 - 0.5 * Math.cos(Math.PI * (time - way.since) / duration);
      sum = space.along(sum, way.way, share);
    }
    value = sum;
  }

  @Override
  public double[] value() {
    return value;
  }

  @Override
  public boolean arrived() {
    return ways.isEmpty();
  }
}
