package org.selectiverenderer.control.budget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The choices are those of known answers, near the best, and stay where they are. */
class MultipleChoiceKnapsackTest {
  /** The classes of weights and savings tell apart what differs by more than this. */
  private static final double CLASS = 0.1;

  @Test
  void theHullLeavesOutVersionsThatAreDearerThanAnotherOrThanAMix() {
    assertThat(choices(new long[] {10, 20, 30}, 8, 4, 2).hull()).containsExactly(0, 1, 2);
    // 20 triangles that lose more than half of what 10 and 30 lose.
    assertThat(choices(new long[] {10, 20, 30}, 8, 7, 2).hull()).containsExactly(0, 2);
    // Dearer and no better; equally dear and worse.
    assertThat(choices(new long[] {30, 10, 40, 30}, 2, 8, 2, 5).hull()).containsExactly(1, 0);
    assertThat(choices(new long[] {5}, 3).hull()).containsExactly(0);
  }

  @Test
  void aVersionThatIsResumedIsKeptLikeOneThatWasChosen() {
    VersionChoices some = choices(new long[] {1, 11}, 60, 10);
    VersionChoices worthier = choices(new long[] {1, 11}, 70, 10);
    MultipleChoiceKnapsack fresh = new MultipleChoiceKnapsack(List.of(some, worthier), 1);
    assertThat(chosen(fresh, 12)).containsExactly(0, 1);
    MultipleChoiceKnapsack resumed = new MultipleChoiceKnapsack(List.of(some, worthier), 1);
    resumed.resume(0, 1);
    resumed.resume(1, 7); // There is no such version.
    assertThat(chosen(resumed, 12)).as("not worth twice as much").containsExactly(1, 0);
    assertThat(chosen(resumed, 22)).containsExactly(1, 1);
    assertThat(chosen(resumed, 2)).containsExactly(0, 0);
  }

  @Test
  void stepsAreTakenInTheOrderOfWhatTheySavePerTriangle() {
    MultipleChoiceKnapsack two =
        problem(
            choices(new long[] {1, 11, 31}, 70, 30, 10), // saves 4, then 1 per triangle
            choices(new long[] {2, 12, 22}, 60, 40, 39)); // saves 2, then 0.1

    assertThat(chosen(two, 3)).containsExactly(0, 0);
    assertThat(chosen(two, 12)).containsExactly(0, 0);
    assertThat(chosen(two, 13)).containsExactly(1, 0);
    assertThat(chosen(two, 23)).containsExactly(1, 1);
    assertThat(two.cost()).isEqualTo(23);
    assertThat(chosen(two, 43)).containsExactly(2, 1);
    assertThat(chosen(two, 1000)).containsExactly(2, 2);
    assertThat(two.cost()).isEqualTo(53);
    assertThat(chosen(two, 0)).containsExactly(0, 0);
    assertThat(two.cost()).isEqualTo(two.leastCost()).isEqualTo(3);
  }

  @Test
  void aHeavyObjectGetsItsTrianglesFirst() {
    VersionChoices chair = choices(new long[] {10, 110}, 1, 0);
    MultipleChoiceKnapsack two = problem(chair, chair);

    two.weigh(1, 2);
    assertThat(chosen(two, 120)).containsExactly(0, 1);
    two.weigh(0, 8);
    assertThat(chosen(two, 120)).containsExactly(1, 0);
    assertThat(changed(two)).containsExactlyInAnyOrder(0, 1);
    chosen(two, 120);
    assertThat(changed(two)).isEmpty();
  }

  @Test
  void nothingIsSpentOnAnObjectThatIsNotThere() {
    VersionChoices chair = choices(new long[] {10, 110}, 1, 0);
    MultipleChoiceKnapsack two = problem(chair, chair);
    two.weigh(0, 5);

    two.present(0, false);
    assertThat(chosen(two, 110)).containsExactly(0, 1);
    two.present(0, true);
    assertThat(chosen(two, 120)).containsExactly(1, 0);
  }

  @Test
  void noChoiceOfSmallProblemsIsBetterByMoreThanOneStep() {
    Random random = new Random(5);
    for (int round = 0; round < 400; round++) {
      List<VersionChoices> items = randomItems(random, 1 + random.nextInt(5));
      MultipleChoiceKnapsack problem = new MultipleChoiceKnapsack(items, 0);
      double[] weights = new double[items.size()];
      for (int i = 0; i < weights.length; i++) {
        weights[i] = Math.exp(3 * random.nextGaussian());
        problem.weigh(i, weights[i]);
      }
      long budget = problem.leastCost() + random.nextInt(4000);

      problem.solve(budget);

      assertThat(problem.cost()).isEqualTo(cost(items, problem)).isLessThanOrEqualTo(budget);
      double none = loss(items, weights, i -> items.get(i).hull()[0]);
      double saved = none - loss(items, weights, problem::choice);
      double best = none - best(items, weights, 0, budget, new int[items.size()]);
      assertThat(saved)
          .as("round %d", round)
          .isGreaterThanOrEqualTo((1 - CLASS) * best - greatestStep(items, weights));
    }
  }

  @Test
  void afterManyChangesOfWeightsTheChoicesAreAsGoodAsOfANewProblem() {
    Random random = new Random(6);
    List<VersionChoices> items = randomItems(random, 60);
    MultipleChoiceKnapsack followed = new MultipleChoiceKnapsack(items, 0.25);
    double[] weights = new double[items.size()];
    Arrays.fill(weights, 1);
    long all = items.stream().mapToLong(MultipleChoiceKnapsackTest::dearest).sum();
    for (int frame = 0; frame < 300; frame++) {
      for (int change = 0; change < 5; change++) {
        int i = random.nextInt(weights.length);
        weights[i] *= Math.exp(0.3 * random.nextGaussian());
        followed.weigh(i, weights[i]);
      }
      followed.present(frame % 60, false);
      followed.solve(all / 2);
      followed.present(frame % 60, true);
      MultipleChoiceKnapsack anew = new MultipleChoiceKnapsack(items, 0);
      for (int i = 0; i < weights.length; i++) {
        anew.weigh(i, weights[i]);
      }
      long most = Math.round(all * (0.5 + 0.4 * Math.sin(0.1 * frame)));
      long budget = Math.max(most, followed.leastCost());

      followed.solve(budget);
      anew.solve(budget);

      assertThat(followed.cost()).isEqualTo(cost(items, followed)).isLessThanOrEqualTo(budget);
      double none = loss(items, weights, i -> items.get(i).hull()[0]);
      assertThat(none - loss(items, weights, followed::choice))
          .as("frame %d", frame)
          .isGreaterThanOrEqualTo(
              (none - loss(items, weights, anew::choice)) * (1 - CLASS) / 1.25
                  - greatestStep(items, weights));
    }
  }

  @Test
  void aGrowingBudgetNeverLosesMore() {
    Random random = new Random(7);
    List<VersionChoices> items = randomItems(random, 40);
    double[] weights = random.doubles(40).toArray();
    for (double hysteresis : new double[] {0, 0.25, 1}) {
      MultipleChoiceKnapsack problem = new MultipleChoiceKnapsack(items, hysteresis);
      for (int i = 0; i < 40; i++) {
        problem.weigh(i, weights[i]);
      }
      double none = loss(items, weights, i -> items.get(i).hull()[0]);
      double before = 0;
      for (long budget = problem.leastCost(); budget < 40_000; budget += 31) {
        problem.solve(budget);
        assertThat(problem.cost()).isLessThanOrEqualTo(budget);
        double saved = none - loss(items, weights, problem::choice);
        assertThat(saved).isGreaterThanOrEqualTo(before * (1 - CLASS / 10));
        before = saved;
      }
      assertThat(problem.cost())
          .isEqualTo(items.stream().mapToLong(MultipleChoiceKnapsackTest::dearest).sum());
    }
  }

  @Test
  void smallerStepsGetWhatALargeOneLeaves() {
    VersionChoices statue = choices(new long[] {10, 100_010}, 100, 0);
    VersionChoices cup = choices(new long[] {10, 110, 210}, 0.05, 0.01, 0);
    MultipleChoiceKnapsack problem = problem(statue, cup, cup);

    assertThat(chosen(problem, 50_000)).containsExactly(0, 2, 2);
    assertThat(chosen(problem, 250)).containsExactly(0, 1, 1);
    assertThat(chosen(problem, 100_030)).containsExactly(1, 0, 0);
    assertThat(chosen(problem, 100_130)).containsExactly(1, 1, 0);
  }

  @Test
  void equalWorthDoesNotTakeTurnsAndClearlyMoreWorthDoes() {
    VersionChoices chair = choices(new long[] {10, 110}, 1, 0);
    MultipleChoiceKnapsack two = new MultipleChoiceKnapsack(List.of(chair, chair), 0.25);
    two.weigh(0, 1.02);
    assertThat(chosen(two, 120)).containsExactly(1, 0);
    for (int frame = 0; frame < 20; frame++) { // Each in turn is worth a tenth more.
      two.weigh(frame % 2, 1);
      two.weigh(1 - frame % 2, 1.1);
      assertThat(chosen(two, 120)).containsExactly(1, 0);
    }
    two.weigh(0, 1);
    two.weigh(1, 1.6);
    assertThat(chosen(two, 120)).containsExactly(0, 1);
    two.weigh(1, 1);
    assertThat(chosen(two, 120)).containsExactly(0, 1);
  }

  @Test
  void theSameWeightsAndTheSameBudgetChangeNothing() {
    Random random = new Random(8);
    List<VersionChoices> items = randomItems(random, 50);
    MultipleChoiceKnapsack problem = new MultipleChoiceKnapsack(items, 0.25);
    for (int round = 0; round < 100; round++) {
      for (int i = 0; i < 50; i++) {
        problem.weigh(i, Math.exp(2 * random.nextGaussian()));
      }
      long budget = random.nextInt(40_000);
      problem.solve(budget);
      problem.solve(budget);
      assertThat(changed(problem)).isEmpty();
    }
  }

  @Test
  void weightsOfAnySizeAreTaken() {
    VersionChoices chair = choices(new long[] {10, 110, 400}, 1, 0.5, 0);
    MultipleChoiceKnapsack three = problem(chair, chair, chair);
    three.weigh(0, 0);
    three.weigh(1, Double.NaN);
    three.weigh(2, Double.POSITIVE_INFINITY);

    assertThat(chosen(three, 420)).containsExactly(0, 0, 2);
    assertThat(chosen(three, 1200)).containsExactly(2, 2, 2);
    three.weigh(2, 1e-300);
    three.weigh(0, 1e300);
    assertThat(chosen(three, 420)).containsExactly(2, 0, 0);
  }

  @Test
  void numbersThatAreNoCostsOrLossesAreRefused() {
    assertThatThrownBy(() -> choices(new long[] {1, 2}, 1)).hasMessageContaining("2 costs and 1");
    assertThatThrownBy(() -> choices(new long[] {-1}, 1)).hasMessageContaining("at least 0");
    assertThatThrownBy(() -> choices(new long[] {1}, Double.NaN)).hasMessageContaining("finite");
    assertThatThrownBy(() -> new MultipleChoiceKnapsack(List.of(), -1))
        .hasMessageContaining("hysteresis");
  }

  private interface Choice {
    int of(int item);
  }

  private static VersionChoices choices(long[] costs, double... losses) {
    return new VersionChoices(
        Arrays.stream(costs).boxed().toList(), Arrays.stream(losses).boxed().toList());
  }

  private static MultipleChoiceKnapsack problem(VersionChoices... items) {
    return new MultipleChoiceKnapsack(List.of(items), 0);
  }

  private static List<Integer> chosen(MultipleChoiceKnapsack problem, long budget) {
    problem.solve(budget);
    List<Integer> chosen = new ArrayList<>();
    for (int i = 0; i < problem.size(); i++) {
      chosen.add(problem.choice(i));
    }
    return chosen;
  }

  private static List<Integer> changed(MultipleChoiceKnapsack problem) {
    List<Integer> changed = new ArrayList<>();
    problem.forEachChanged(changed::add);
    return changed;
  }

  private static List<VersionChoices> randomItems(Random random, int count) {
    List<VersionChoices> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int versions = 1 + random.nextInt(4);
      long[] costs = new long[versions];
      double[] losses = new double[versions];
      for (int v = 0; v < versions; v++) {
        costs[v] = random.nextInt(1000);
        losses[v] = random.nextDouble();
      }
      items.add(choices(costs, losses));
    }
    return items;
  }

  private static long dearest(VersionChoices item) {
    int[] hull = item.hull();
    return item.costs().get(hull[hull.length - 1]);
  }

  private static long cost(List<VersionChoices> items, MultipleChoiceKnapsack problem) {
    long cost = 0;
    for (int i = 0; i < items.size(); i++) {
      cost += items.get(i).costs().get(problem.choice(i));
    }
    return cost;
  }

  private static double loss(List<VersionChoices> items, double[] weights, Choice choice) {
    double loss = 0;
    for (int i = 0; i < items.size(); i++) {
      loss += weights[i] * items.get(i).losses().get(choice.of(i));
    }
    return loss;
  }

  /** Returns the least loss, of all choices within the budget. */
  private static double best(
      List<VersionChoices> items, double[] weights, int item, long budget, int[] chosen) {
    if (budget < 0) {
      return Double.POSITIVE_INFINITY;
    }
    if (item == items.size()) {
      return loss(items, weights, i -> chosen[i]);
    }
    double least = Double.POSITIVE_INFINITY;
    for (int version = 0; version < items.get(item).costs().size(); version++) {
      chosen[item] = version;
      long left = budget - items.get(item).costs().get(version);
      least = Math.min(least, best(items, weights, item + 1, left, chosen));
    }
    return least;
  }

  private static double greatestStep(List<VersionChoices> items, double[] weights) {
    double greatest = 0;
    for (int i = 0; i < items.size(); i++) {
      int[] hull = items.get(i).hull();
      List<Double> losses = items.get(i).losses();
      for (int step = 1; step < hull.length; step++) {
        greatest =
            Math.max(greatest, weights[i] * (losses.get(hull[step - 1]) - losses.get(hull[step])));
      }
    }
    return greatest;
  }
}
