package org.selectiverenderer.experiment.threshold;

/**
 * How a staircase goes (Levitt, H. 1971. Transformed up-down methods in psychoacoustics. Journal of
 * the Acoustical Society of America 49, 467-477): so many right answers in a row make it harder,
 * one wrong answer makes it easier. It settles where a right answer has the probability p with
 * p^down = 1/2: 0.707 for 2, 0.794 for 3.
 *
 * @param down right answers in a row, at least 1
 * @param reversals turns of direction after which it is over
 * @param discarded of these, the first, which do not count: the staircase is still on its way
 * @param mostTrials after which it is over in any case
 */
record StaircaseRule(int down, int reversals, int discarded, int mostTrials) {
  /**
   * @throws IllegalArgumentException if no even number of reversals is left to count: peaks and
   *     valleys must weigh alike
   */
  public StaircaseRule {
    if (down < 1 || discarded < 0 || reversals - discarded < 2) {
      throw new IllegalArgumentException("no rule");
    }
    if ((reversals - discarded) % 2 != 0) {
      throw new IllegalArgumentException("an odd number of reversals would count");
    }
  }

  /** The share of right answers at which it settles. */
  public double target() {
    return Math.pow(0.5, 1.0 / down);
  }
}
