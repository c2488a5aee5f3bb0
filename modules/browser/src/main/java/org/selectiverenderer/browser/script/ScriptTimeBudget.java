package org.selectiverenderer.browser.script;

/**
 * The time budget of all scripts together at one time stamp. Each call has a limit of its own, but
 * scripts that trigger each other make many calls.
 */
final class ScriptTimeBudget {
  static final int MOST_SECONDS = 10;

  private double stamp = Double.NaN;
  private double seconds;

  /**
   * Adds the time of a call that has ended.
   *
   * @param at the time stamp
   * @param took the duration of the call in seconds
   * @return whether this call exceeds the budget
   */
  boolean add(double at, double took) {
    boolean before = over(at);
    seconds += took;
    return !before && over(at);
  }

  /** Returns whether the budget of a time stamp is used up. */
  boolean over(double at) {
    if (at != stamp) {
      stamp = at;
      seconds = 0;
    }
    return seconds > MOST_SECONDS;
  }
}
