package org.selectiverenderer.study.threshold;

/**
 * The rule of a transformed up-down staircase (Levitt, H. 1971. Transformed up-down methods in
 * psychoacoustics. Journal of the Acoustical Society of America 49, 467-477): {@code down} right
 * answers in a row make it harder, one wrong answer makes it easier. It converges to the level at
 * which a right answer has the probability p with p^down = 1/2: 0.707 for 2, 0.794 for 3.
 *
 * @param down right answers in a row, at least 1
 * @param reversals number of reversals after which the staircase ends
 * @param discarded number of first reversals that do not count, as the staircase has not converged
 * @param mostTrials number of trials after which the staircase ends in any case
 */
record StaircaseRule(int down, int reversals, int discarded, int mostTrials) {
  /**
   * @throws IllegalArgumentException if the number of reversals that count is not even and at least
   *     two: as many peaks as valleys must count
   */
  public StaircaseRule {
    if (down < 1 || discarded < 0 || reversals - discarded < 2) {
      throw new IllegalArgumentException("no rule");
    }
    if ((reversals - discarded) % 2 != 0) {
      throw new IllegalArgumentException("an odd number of reversals would count");
    }
  }

  /** Returns the share of right answers to which the staircase converges. */
  public double target() {
    return Math.pow(0.5, 1.0 / down);
  }
}
