package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A transformed up-down staircase (Levitt 1971, "Transformed up-down methods in psychoacoustics")
 * over levels 0 (the easiest) to {@code levels - 1}. It begins at the easiest level with large
 * steps, which are halved at each reversal until they are one level. After one wrong response the
 * next level is easier, after {@code down} correct ones in a row it is harder.
 */
public final class UpDownStaircase {
  /**
   * Number of consecutive steps beyond an end of the levels that end the staircase: an observer who
   * only guesses passes the ten trials of a two-down rule once in a thousand times.
   */
  private static final int BEYOND = 5;

  private final int levels;
  private final int down;
  private final int reversals;
  private final int discarded;
  private final int most;
  private final List<Integer> turns = new ArrayList<>();
  private int level;
  private int step;
  private int inARow;
  private int direction;
  private int beyond;
  private int trials;

  /**
   * @param levels number of levels, at least 2
   * @param down number of correct responses in a row after which the next level is harder
   * @param reversals number of reversals that end the staircase
   * @param discarded number of first reversals that the estimate leaves out
   * @param most number of trials that end it in any case
   */
  public UpDownStaircase(int levels, int down, int reversals, int discarded, int most) {
    this.levels = levels;
    this.down = down;
    this.reversals = reversals;
    this.discarded = discarded;
    this.most = most;
    step = Math.max(1, levels / 4);
  }

  /** Returns the level of the next trial, from 0. */
  public int level() {
    return level;
  }

  /** Records the response to a trial at {@link #level}. */
  public void answered(boolean correct) {
    trials++;
    inARow = correct ? inARow + 1 : 0;
    if (!correct) {
      go(-1);
    } else if (inARow == down) {
      inARow = 0;
      go(1);
    }
  }

  /**
   * Moves one step.
   *
   * @param towards 1 for harder levels, -1 for easier ones
   */
  private void go(int towards) {
    if (direction == -towards) {
      turns.add(level);
      step = Math.max(1, step / 2);
    }
    direction = towards;
    int next = Math.max(0, Math.min(levels - 1, level + towards * step));
    beyond = next == level ? beyond + 1 : 0;
    level = next;
  }

  /** Returns whether the staircase has ended. */
  public boolean over() {
    return converged() || pinned() || trials >= most;
  }

  /** Returns whether it has had all its reversals. */
  public boolean converged() {
    return turns.size() >= reversals;
  }

  /** Returns whether it ended at the easiest or the hardest level, which it could not pass. */
  public boolean pinned() {
    return beyond >= BEYOND;
  }

  /** Returns the levels of the reversals so far. */
  public List<Integer> reversals() {
    return List.copyOf(turns);
  }

  /** Returns the levels of the reversals that count; none before the staircase has converged. */
  public List<Integer> counting() {
    return converged() ? List.copyOf(turns.subList(discarded, reversals)) : List.of();
  }

  /** Returns the mean level of the reversals that count; empty before it has converged. */
  public OptionalDouble threshold() {
    return counting().stream().mapToInt(Integer::intValue).average();
  }

  /** Returns the number of trials so far. */
  public int trials() {
    return trials;
  }
}
