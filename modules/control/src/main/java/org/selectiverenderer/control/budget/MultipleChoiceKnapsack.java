package org.selectiverenderer.control.budget;

import java.util.List;
import java.util.function.IntConsumer;

/**
 * Chooses one version of each object, so that the sum of the losses is small and the sum of the
 * costs stays within a budget: the multiple-choice knapsack problem, solved anew in every frame at
 * the cost of what has changed.
 *
 * <p>The relaxed problem has a known optimum (Sinha and Zoltners, "The multiple-choice knapsack
 * problem", Operations Research 27, 1979): begin with the cheapest version of each object, and take
 * the steps along the convex hulls of all objects in the order of the loss that they save per
 * triangle, until the next does not fit. What the whole problem's best solution could save beyond
 * that is less than this one step saves. Pisinger ("A minimal algorithm for the multiple-choice
 * knapsack problem", European Journal of Operational Research 83, 1995) calls it the greedy
 * solution; Funkhouser and Sequin (SIGGRAPH 1993) choose levels of detail by the same order. Here,
 * smaller steps that come later still get what is left.
 *
 * <p>From frame to frame only the weights of objects change. So the steps are not sorted: each is
 * in a bucket of steps whose saving per triangle is the same within a sixteenth of an octave (4 %),
 * and an object whose weight has left its class moves its steps to other buckets, in a time that
 * does not depend on the number of objects. A solution goes through the buckets, of which there are
 * 2048, and through the steps that it takes, drops, or finds not to fit.
 *
 * <p>A step that is taken counts as more worth by the hysteresis, so that two objects of nearly
 * equal worth at the border do not take turns: another step takes its place only if that saves so
 * much more per triangle. The same weights and the same budget again change nothing, and a larger
 * budget never loses more.
 *
 * <p>Not thread-safe.
 */
public final class MultipleChoiceKnapsack {
  /** Buckets for each doubling of the saving per triangle. */
  private static final int PER_OCTAVE = 16;

  /** The savings per triangle that the buckets tell apart: from 2^-96 to 2^32. */
  private static final int LEAST_OCTAVE = -96;

  private static final int OCTAVES = 128;
  private static final int BUCKETS = OCTAVES * PER_OCTAVE;

  /**
   * How far, in classes, a weight may be from the middle of its class before it changes the class:
   * more than a half, so that a weight at the border of two classes stays in one.
   */
  private static final double STAY = 0.75;

  /** Steps that do not fit before the search for smaller ones ends. */
  private static final int MISFITS = 1024;

  private final int hysteresis;

  /** For each item: the first of its steps; one more at the end. */
  private final int[] firstStep;

  /** For each item: the version before its first step. */
  private final int[] cheapest;

  private final long[] cheapestCost;
  private final int[] taken;
  private final boolean[] present;
  private final int[] weightClass;

  /** The weights for which an item stays in its class. */
  private final double[] weightFrom;

  private final double[] weightTo;

  /** For each step: the version that it leads to, what it costs, whose it is, and its worth. */
  private final int[] version;

  private final long[] stepCost;
  private final int[] item;
  private final int[] worthClass;

  /** For each bucket two lists: of steps not taken at an even index, of taken ones at the odd. */
  private final StepLists lists;

  private final int[] dropped;
  private int drops;
  private final int[] changed;
  private final boolean[] isChanged;
  private int changes;
  private long leastCost;
  private long cost;

  /**
   * Creates a problem in which every item has weight 1 and shows its cheapest version.
   *
   * @param items the versions of each item
   * @param hysteresis by what share a step must be worth more than a taken one to take its place:
   *     0.25 for a quarter more
   */
  public MultipleChoiceKnapsack(List<VersionChoices> items, double hysteresis) {
    if (!(hysteresis >= 0 && hysteresis <= 100)) {
      throw new IllegalArgumentException("a hysteresis is from 0 to 100, not " + hysteresis);
    }
    this.hysteresis = (int) Math.ceil(classes(1 + hysteresis) - 1e-9);
    int count = items.size();
    firstStep = new int[count + 1];
    cheapest = new int[count];
    cheapestCost = new long[count];
    int[][] hulls = new int[count][];
    for (int i = 0; i < count; i++) {
      hulls[i] = items.get(i).hull();
      firstStep[i + 1] = firstStep[i] + hulls[i].length - 1;
      cheapest[i] = hulls[i][0];
      cheapestCost[i] = items.get(i).costs().get(cheapest[i]);
    }
    taken = new int[count];
    present = new boolean[count];
    weightClass = new int[count];
    weightFrom = new double[count];
    weightTo = new double[count];
    isChanged = new boolean[count];
    changed = new int[count];
    dropped = new int[count];
    int steps = firstStep[count];
    version = new int[steps];
    stepCost = new long[steps];
    item = new int[steps];
    worthClass = new int[steps];
    lists = new StepLists(stepCost, 2 * BUCKETS);
    for (int i = 0; i < count; i++) {
      VersionChoices choices = items.get(i);
      for (int step = firstStep[i]; step < firstStep[i + 1]; step++) {
        int from = hulls[i][step - firstStep[i]];
        int to = hulls[i][step - firstStep[i] + 1];
        version[step] = to;
        stepCost[step] = choices.costs().get(to) - choices.costs().get(from);
        item[step] = i;
        worthClass[step] = (int) Math.floor(classes(choices.saved(from, to)));
      }
      classify(i, 1);
      present(i, true);
    }
  }

  /** Returns a ratio as a number of classes: the logarithm in sixteenths of an octave. */
  private static double classes(double ratio) {
    return Math.log(ratio) / Math.log(2) * PER_OCTAVE;
  }

  /** Returns the number of items. */
  public int size() {
    return present.length;
  }

  /**
   * Sets by how much the losses of an item count.
   *
   * @param weight at least 0; what is not a number counts as 0
   */
  public void weigh(int of, double weight) {
    if (weight >= weightFrom[of] && weight <= weightTo[of]) {
      return;
    }
    int before = weightClass[of];
    classify(of, weight);
    if (weightClass[of] != before && present[of]) {
      int now = weightClass[of];
      weightClass[of] = before;
      unlist(of);
      weightClass[of] = now;
      enlist(of);
    }
  }

  private void classify(int of, double weight) {
    double exact = weight > 0 ? classes(weight) : Double.NEGATIVE_INFINITY;
    double least = LEAST_OCTAVE * PER_OCTAVE;
    double most = least + BUCKETS;
    int middle = (int) Math.round(Math.max(least, Math.min(most, exact)));
    weightClass[of] = middle;
    weightFrom[of] = middle <= least ? 0 : power(middle - STAY);
    weightTo[of] = middle >= most ? Double.POSITIVE_INFINITY : power(middle + STAY);
  }

  private static double power(double classes) {
    return Math.pow(2, classes / PER_OCTAVE);
  }

  /**
   * Sets whether an item is there. One that is not costs nothing, and its version does not change.
   */
  public void present(int of, boolean there) {
    if (present[of] == there) {
      return;
    }
    present[of] = there;
    if (there) {
      leastCost += cheapestCost[of];
      enlist(of);
    } else {
      leastCost -= cheapestCost[of];
      unlist(of);
    }
  }

  /**
   * Lets an item have a version as if the last solution had chosen it, so that others take its
   * place only by the hysteresis. A version that no solution chooses leaves the item as it is.
   */
  public void resume(int of, int chosen) {
    for (int steps = 0; steps <= firstStep[of + 1] - firstStep[of]; steps++) {
      int reached = steps == 0 ? cheapest[of] : version[firstStep[of] + steps - 1];
      if (reached == chosen) {
        if (present[of]) {
          unlist(of);
        }
        taken[of] = steps;
        if (present[of]) {
          enlist(of);
        }
        return;
      }
    }
  }

  /**
   * Chooses the versions.
   *
   * @param budget the most that they may cost together; where even the cheapest versions cost more,
   *     these are chosen
   */
  public void solve(long budget) {
    for (int i = 0; i < changes; i++) {
      isChanged[changed[i]] = false;
    }
    changes = 0;
    fill(budget);
    if (drops > 0) {
      for (int i = 0; i < drops; i++) {
        unlist(dropped[i]);
        enlist(dropped[i]);
      }
      // What was dropped counted as more worth than others that are now the next to take.
      fill(budget);
    }
  }

  /** Goes through the steps in the order of their worth, and takes, keeps or drops each. */
  private void fill(long budget) {
    drops = 0;
    long left = budget - leastCost;
    int misfits = 0;
    for (int at = 2 * BUCKETS - 1; at >= 0; at--) {
      long listed = lists.cost(at);
      if (listed == 0) {
        continue; // There is none, since every step costs something.
      }
      if ((at & 1) == 1) {
        left -= drops == 0 && listed <= left ? listed : keep(at, left);
        continue;
      }
      for (int step = lists.first(at); step != StepLists.NONE && misfits < MISFITS; ) {
        int following = lists.next(step);
        int of = item[step];
        if (stepCost[step] <= left && step == firstStep[of] + taken[of]) {
          left -= stepCost[step];
          lists.remove(step);
          lists.append(step, at + 2 * hysteresis + 1);
          taken[of]++;
          note(of);
        } else {
          misfits++;
        }
        step = following;
      }
    }
    cost = budget < leastCost ? leastCost : budget - left;
  }

  /**
   * Keeps the steps of a list that fit and whose item has kept the steps before, and drops the
   * others; returns what it keeps cost.
   */
  private long keep(int list, long left) {
    long sum = 0;
    for (int step = lists.first(list); step != StepLists.NONE; step = lists.next(step)) {
      int of = item[step];
      int number = step - firstStep[of];
      if (number < taken[of] && sum + stepCost[step] <= left) {
        sum += stepCost[step];
      } else if (number < taken[of]) {
        taken[of] = number; // The lists follow when all have been gone through.
        note(of);
        dropped[drops++] = of;
      }
    }
    return sum;
  }

  private void note(int of) {
    if (!isChanged[of]) {
      isChanged[of] = true;
      changed[changes++] = of;
    }
  }

  /** Returns the version that the last solution chose for an item. */
  public int choice(int of) {
    return taken[of] == 0 ? cheapest[of] : version[firstStep[of] + taken[of] - 1];
  }

  /** Gives each item whose version the last solution changed. */
  public void forEachChanged(IntConsumer action) {
    for (int i = 0; i < changes; i++) {
      action.accept(changed[i]);
    }
  }

  /** Returns what the versions of the last solution cost together. */
  public long cost() {
    return cost;
  }

  /** Returns what the cheapest versions of the items that are there cost together. */
  public long leastCost() {
    return leastCost;
  }

  private void enlist(int of) {
    for (int step = firstStep[of]; step < firstStep[of + 1]; step++) {
      boolean isTaken = step - firstStep[of] < taken[of];
      int bucket = bucket(step);
      lists.append(step, isTaken ? 2 * (bucket + hysteresis) + 1 : 2 * bucket);
    }
  }

  private void unlist(int of) {
    for (int step = firstStep[of]; step < firstStep[of + 1]; step++) {
      lists.remove(step);
    }
  }

  private int bucket(int step) {
    int worth = weightClass[item[step]] + worthClass[step] - LEAST_OCTAVE * PER_OCTAVE;
    return Math.max(0, Math.min(BUCKETS - 1 - hysteresis, worth));
  }
}
