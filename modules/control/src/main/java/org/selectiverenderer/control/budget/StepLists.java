package org.selectiverenderer.control.budget;

import java.util.Arrays;

/**
 * Doubly linked lists of steps, with the sum of the costs of each list. A step is a number and is
 * in at most one list; all operations take constant time and make no objects.
 */
final class StepLists {
  static final int NONE = -1;

  private final long[] costs;
  private final int[] list;
  private final int[] next;
  private final int[] previous;
  private final int[] head;
  private final int[] tail;
  private final long[] sum;

  /**
   * @param costs of the steps
   */
  StepLists(long[] costs, int lists) {
    this.costs = costs;
    list = new int[costs.length];
    next = new int[costs.length];
    previous = new int[costs.length];
    head = new int[lists];
    tail = new int[lists];
    sum = new long[lists];
    Arrays.fill(head, NONE);
    Arrays.fill(tail, NONE);
  }

  /** Returns the first step of a list, or {@link #NONE}. */
  int first(int of) {
    return head[of];
  }

  /** Returns the step after another one in its list, or {@link #NONE}. */
  int next(int step) {
    return next[step];
  }

  /** Returns what the steps of a list cost together. */
  long cost(int of) {
    return sum[of];
  }

  void append(int step, int to) {
    list[step] = to;
    sum[to] += costs[step];
    previous[step] = tail[to];
    next[step] = NONE;
    if (tail[to] == NONE) {
      head[to] = step;
    } else {
      next[tail[to]] = step;
    }
    tail[to] = step;
  }

  /** Removes a step from its list. */
  void remove(int step) {
    int from = list[step];
    sum[from] -= costs[step];
    if (previous[step] == NONE) {
      head[from] = next[step];
    } else {
      next[previous[step]] = next[step];
    }
    if (next[step] == NONE) {
      tail[from] = previous[step];
    } else {
      previous[next[step]] = previous[step];
    }
  }
}
