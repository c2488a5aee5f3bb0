package org.selectiverenderer.control.budget;

/**
 * Finds the triangles that may be shown so that a frame takes a given time: it compares the frames'
 * times with the goal, and lets the triangles shrink or grow until they agree.
 *
 * <p>It assumes only that more triangles take longer. The times are smoothed over about ten frames,
 * and after each change it waits until the smoothed time is that of the new triangles. It changes
 * by the square root of the ratio of goal and time, which converges without swinging even where the
 * time grows with the square of the triangles, and by a tenth at most when it lets them grow. Where
 * the next larger version has more than a tenth of all triangles, several such changes add up until
 * it fits, as far as the ratio promises that its frames will take less than the goal. It aims a
 * twentieth below the goal, and leaves alone what is less than a tenth below. Of the last three
 * frames the middle time counts, so that one that takes long, as when a file arrives or new objects
 * are measured, changes nothing; of several, each counts as four times the goal at most.
 *
 * <p>Not thread-safe.
 */
public final class FrameTimeRegulator {
  private static final double SMOOTHING = 0.2;
  private static final int SETTLE = 15;
  private static final double SPIKE = 4;
  private static final double LOW = 0.9;
  private static final double AIM = 0.95;
  private static final double MOST_DOWN = 0.5;
  private static final double MOST_UP = 1.1;

  private final double goal;
  private double last = Double.NaN;
  private double lastButOne = Double.NaN;
  private double smoothed = Double.NaN;
  private int frames;
  private double triangles = Double.POSITIVE_INFINITY;

  /**
   * @param goal the time that a frame should take at most, in milliseconds, above 0
   */
  public FrameTimeRegulator(double goal) {
    this.goal = goal;
  }

  /**
   * Hears of a frame.
   *
   * @param ms the time that it took
   * @param shown the triangles of the scene that it showed
   */
  public void frame(double ms, long shown) {
    double counted = Math.min(middle(ms, last, lastButOne), SPIKE * goal);
    lastButOne = last;
    last = ms;
    smoothed = Double.isNaN(smoothed) ? counted : smoothed + SMOOTHING * (counted - smoothed);
    frames++;
    if (frames < SETTLE || (smoothed <= goal && smoothed >= LOW * goal)) {
      return;
    }
    double ratio = Math.sqrt(AIM * goal / smoothed);
    // What may be shown beyond what there is has no effect, and would have to be taken back first.
    triangles =
        ratio > 1
            ? Math.min(Math.max(triangles, shown) * MOST_UP, shown * ratio)
            : Math.min(triangles, shown) * Math.max(MOST_DOWN, ratio);
    frames = 0;
  }

  /** Returns the middle one of three times; the first while others are not known. */
  private static double middle(double a, double b, double c) {
    double middle = Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    return Double.isNaN(middle) ? a : middle;
  }

  /**
   * Returns the triangles that may be shown now.
   *
   * @param least the triangles with the smallest versions; never fewer are returned
   * @param most the triangles with the largest versions; never more are returned
   */
  public long triangles(long least, long most) {
    triangles = Math.max(least, Math.min(most, triangles));
    return (long) triangles;
  }

  /** Returns the smoothed time of a frame in milliseconds; NaN before the first frame. */
  public double smoothed() {
    return smoothed;
  }
}
