package org.selectiverenderer.study.rehearsal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.selectiverenderer.study.session.StudyPlan;

/**
 * How often each combination of levels comes at each place of a block, and directly after each
 * other one, over all participants of a plan. Trials of one combination that follow each other
 * count as one, so that blocks whose trials come in groups are judged by the order of the groups.
 *
 * @param block name of the block
 * @param combinations the combinations, sorted
 * @param atPlace for each combination, how often it comes at each place
 * @param after for each combination, how often it comes directly after each one
 */
public record PlanBalance(
    String block,
    List<String> combinations,
    List<List<Integer>> atPlace,
    List<List<Integer>> after) {
  /** Number of combinations up to which a balance is told; a list of stimuli has none. */
  public static final int MOST = 24;

  public PlanBalance {
    combinations = List.copyOf(combinations);
    atPlace = List.copyOf(atPlace);
    after = List.copyOf(after);
  }

  /** Returns the balance of each block that has 2 to {@value #MOST} combinations. */
  public static List<PlanBalance> of(StudyPlan plan) {
    Map<String, List<List<String>>> orders = new TreeMap<>();
    List<String> names = new ArrayList<>();
    for (StudyPlan.Place place : plan.places()) {
      for (StudyPlan.Block block : place.blocks()) {
        if (!names.contains(block.name())) {
          names.add(block.name());
        }
        orders.computeIfAbsent(block.name(), first -> new ArrayList<>()).add(groups(block));
      }
    }
    List<PlanBalance> all = new ArrayList<>();
    for (String name : names) {
      List<List<String>> own = orders.getOrDefault(name, List.of());
      List<String> known =
          new ArrayList<>(new TreeSet<>(own.stream().flatMap(List::stream).toList()));
      if (known.size() > 1 && known.size() <= MOST) {
        all.add(of(name, known, own));
      }
    }
    return all;
  }

  private static List<String> groups(StudyPlan.Block block) {
    List<String> groups = new ArrayList<>();
    for (StudyPlan.PlannedTrial trial : block.trials()) {
      if (groups.isEmpty() || !groups.get(groups.size() - 1).equals(trial.combination())) {
        groups.add(trial.combination());
      }
    }
    return groups;
  }

  private static PlanBalance of(String name, List<String> known, List<List<String>> orders) {
    int longest = orders.stream().mapToInt(List::size).max().orElse(0);
    int[][] atPlace = new int[known.size()][longest];
    int[][] after = new int[known.size()][known.size()];
    for (List<String> order : orders) {
      for (int place = 0; place < order.size(); place++) {
        int one = known.indexOf(order.get(place));
        atPlace[one][place]++;
        if (place > 0) {
          after[one][known.indexOf(order.get(place - 1))]++;
        }
      }
    }
    return new PlanBalance(name, known, lists(atPlace), lists(after));
  }

  private static List<List<Integer>> lists(int[][] counts) {
    List<List<Integer>> lists = new ArrayList<>();
    for (int[] row : counts) {
      lists.add(Arrays.stream(row).boxed().toList());
    }
    return lists;
  }

  /** Returns whether each combination comes equally often at each place. */
  public boolean placesBalanced() {
    return atPlace.stream().flatMap(List::stream).distinct().count() <= 1;
  }

  /** Returns whether each combination comes equally often directly after each other one. */
  public boolean neighboursBalanced() {
    List<Integer> others = new ArrayList<>();
    for (int one = 0; one < after.size(); one++) {
      for (int other = 0; other < after.size(); other++) {
        if (one != other) {
          others.add(after.get(one).get(other));
        }
      }
    }
    return others.stream().distinct().count() <= 1;
  }

  /** Returns a sentence that says what is balanced. */
  public String sentence() {
    return "block %s: %d combinations are %s over the places and %s as neighbours"
        .formatted(
            block,
            combinations.size(),
            placesBalanced() ? "balanced" : "not balanced",
            neighboursBalanced() ? "balanced" : "not balanced");
  }
}
