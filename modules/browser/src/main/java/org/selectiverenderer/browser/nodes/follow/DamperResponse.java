package org.selectiverenderer.browser.nodes.follow;

import java.util.Arrays;
import java.util.function.DoubleSupplier;

/**
 * The infinite response of dampers (X3D 4.0, 39.3.2): a chain of low-pass filters, each of which
 * reduces the distance to the output of the previous one by the factor e in {@code tau} seconds.
 * The value has arrived when all filters are within the tolerance.
 */
final class DamperResponse implements FollowerResponse {
  /** Share of the distance that counts as arrived if the author gives no tolerance. */
  private static final double NEAR = 1e-4;

  private final FollowerValueSpace space;
  private final DoubleSupplier tau;
  private final DoubleSupplier tolerance;
  private final double[][] filters;
  private double[] destination = {};
  private double last;
  private double longest;
  private boolean arrived = true;

  /**
   * @param order the number of filters, at least 1
   * @param tolerance the tolerance; negative for one in proportion to the distance
   */
  DamperResponse(
      FollowerValueSpace space, int order, DoubleSupplier tau, DoubleSupplier tolerance) {
    this.space = space;
    this.tau = tau;
    this.tolerance = tolerance;
    filters = new double[order][];
  }

  @Override
  public void start(double[] at) {
    Arrays.fill(filters, at);
    destination = at;
    arrived = true;
  }

  @Override
  public void aim(double[] to, double time) {
    if (to.length != destination.length) {
      Arrays.setAll(filters, i -> FollowerValueSpace.fitted(filters[i], to));
    }
    destination = to;
    if (arrived) {
      last = time;
      longest = 0;
    }
    longest = Math.max(longest, farthest());
    arrived = longest == 0;
  }

  @Override
  public void advance(double time) {
    double constant = tau.getAsDouble();
    double share = constant > 0 ? 1 - Math.exp(-Math.max(0, time - last) / constant) : 1;
    last = time;
    double[] before = destination;
    for (int i = 0; i < filters.length; i++) {
      filters[i] = space.along(filters[i], space.way(filters[i], before), share);
      before = filters[i];
    }
    double wanted = tolerance.getAsDouble();
    if (!(farthest() > (wanted < 0 ? NEAR * longest : wanted))) {
      Arrays.fill(filters, destination);
      arrived = true;
    }
  }

  private double farthest() {
    double farthest = 0;
    for (double[] filter : filters) {
      farthest = Math.max(farthest, space.length(space.way(filter, destination)));
    }
    return farthest;
  }

  @Override
  public double[] value() {
    return filters[filters.length - 1];
  }

  @Override
  public boolean arrived() {
    return arrived;
  }
}
