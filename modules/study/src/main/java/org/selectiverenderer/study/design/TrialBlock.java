package org.selectiverenderer.study.design;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A block of trials.
 *
 * @param name letters and digits
 * @param factors the within factors that vary in the block
 * @param stimuli the stimulus list; its columns that have the name of a factor determine the levels
 *     of that factor, the others are crossed with the rows
 * @param pairing how rows and combinations of levels are paired
 * @param repetitions how often each trial comes, at least 1
 * @param order the order of the trials
 * @param runs the most trials in a row with the same level of a factor, or the same cell of a
 *     column; only in random order
 * @param settings settings of all its trials
 * @param phases the phases of each trial
 * @param rest number of trials after which participants may rest; 0 for never
 * @param practice what practice must achieve; empty for a block whose trials count
 * @param staircase the staircase that chooses the trials; empty for an order that is known before
 */
public record TrialBlock(
    String name,
    List<Factor> factors,
    Optional<StimulusList> stimuli,
    Pairing pairing,
    int repetitions,
    Order order,
    Map<String, Integer> runs,
    TrialSettings settings,
    List<TrialPhase> phases,
    int rest,
    Optional<PracticeCriterion> practice,
    Optional<TrialStaircase> staircase) {

  /** How stimuli and combinations of levels are paired. */
  public enum Pairing {
    /** Each participant sees each stimulus in each combination. */
    CROSSED,
    /**
     * Each participant sees each stimulus in one combination; over as many participants of a group
     * as there are combinations, each stimulus comes once in each (lists counterbalanced by a Latin
     * square). Where combinations come in a Latin square or in all orders, each order comes with
     * each pairing over as many participants as the product of their numbers.
     */
    ROTATED;

    /** Returns the spelling in a study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** The order of the trials. */
  public enum Order {
    /** As levels and list have them. */
    FIXED,
    /**
     * All orders of the combinations of levels, one participant of a group after the other. The
     * trials of a combination come together, their stimuli in random order.
     */
    FULL,
    /**
     * The combinations of levels by Williams's squares, so that each comes at each place, and after
     * each other one, equally often. The trials of a combination come together, their stimuli in
     * random order.
     */
    LATIN_SQUARE,
    /** Drawn for each participant, with at most so many alike in a row as the block allows. */
    RANDOM;

    /** Returns the spelling in a study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /**
   * What a practice block must achieve before the session goes on.
   *
   * @param correct share of correct responses in a round, 0 to 1
   * @param rounds number of rounds after which the session goes on nevertheless, flagged
   */
  public record PracticeCriterion(double correct, int rounds) {}

  /**
   * A transformed up-down staircase over the levels of a factor, which are ordered from the easiest
   * to the hardest (Levitt 1971). Each combination of the other factors and stimuli has a staircase
   * of its own; they are interleaved at random.
   *
   * @param factor name of the factor
   * @param down number of correct responses in a row after which the next level is harder
   * @param reversals number of reversals that end it
   * @param discarded number of first reversals that the estimate leaves out
   * @param most number of trials that end it in any case
   */
  public record TrialStaircase(String factor, int down, int reversals, int discarded, int most) {}

  public TrialBlock {
    factors = List.copyOf(factors);
    runs = Map.copyOf(runs);
    phases = List.copyOf(phases);
  }

  /** Returns the factors whose levels the stimulus list does not determine. */
  List<Factor> crossed() {
    return factors.stream()
        .filter(factor -> stimuli.map(list -> !list.columns().contains(factor.name())).orElse(true))
        .toList();
  }
}
