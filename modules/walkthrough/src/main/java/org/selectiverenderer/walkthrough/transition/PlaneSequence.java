package org.selectiverenderer.walkthrough.transition;

/** A sequence of points, of which the first n fill a square evenly for every n (Roberts 2018). */
final class PlaneSequence {
  private static final double FIRST = 0.7548776662466927;
  private static final double SECOND = 0.5698402909980532;

  private PlaneSequence() {}

  /** Returns the first coordinate of a point, from 0 to 1. */
  static double first(long n) {
    return (0.5 + n * FIRST) % 1;
  }

  /** Returns the second coordinate of a point, from 0 to 1. */
  static double second(long n) {
    return (0.5 + n * SECOND) % 1;
  }
}
