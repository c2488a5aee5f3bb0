package org.selectiverenderer.runtime.script;

/**
 * How long scripts have run at one time stamp, all of them together: each call has a limit of its
 * own, but scripts that call each other make many.
 */
final class TimeTogether {
  static final int MOST_SECONDS = 10;

  private double stamp = Double.NaN;
  private double seconds;

  /**
   * A call has ended.
   *
   * @param at the time stamp
   * @param took how long it ran, in seconds
   * @return whether it is the one that takes them beyond the limit
   */
  boolean add(double at, double took) {
    boolean before = over(at);
    seconds += took;
    return !before && over(at);
  }

  /** Whether nothing more may run at a time stamp. */
  boolean over(double at) {
    if (at != stamp) {
      stamp = at;
      seconds = 0;
    }
    return seconds > MOST_SECONDS;
  }
}
