package org.selectiverenderer.study.design;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.study.design.TrialBlock.PracticeCriterion;

/**
 * A participant's progress through a block: which trial comes next. In a block with a practice
 * criterion rounds follow each other until the criterion or the last round is reached; in a block
 * with a staircase the results determine the levels. Belongs to one thread.
 */
public final class BlockProgress {
  private final TrialBlock block;
  private final TrialSequencer sequencer;
  private final int turn;
  private final Map<Integer, List<TrialKey>> recorded;
  private final List<TrialResult> results = new ArrayList<>();
  private final Optional<StaircaseTrials> staircases;
  private List<Trial> order;
  private int round = 1;
  private boolean over;

  /**
   * Makes the progress before the first trial.
   *
   * @param turn the participant's index among those of the group, from 0
   * @param seed random seed of the study
   * @param recorded the orders that were recorded when rounds began, by round; a change of the
   *     study after that does not alter them
   * @throws IllegalArgumentException if no order keeps the block's limits of runs
   */
  public BlockProgress(
      TrialBlock block,
      StudyGroup group,
      int turn,
      long seed,
      Map<Integer, List<TrialKey>> recorded) {
    this.block = block;
    this.turn = turn;
    this.recorded = Map.copyOf(recorded);
    sequencer = new TrialSequencer(block, group, seed);
    staircases =
        block
            .staircase()
            .map(
                rule ->
                    new StaircaseTrials(
                        block, rule, sequencer, turn, seed, block.name() + group.name() + turn));
    order = staircases.isPresent() ? List.of() : round(1);
    over = staircases.isEmpty() && order.isEmpty();
  }

  private List<Trial> round(int number) {
    List<TrialKey> known = recorded.get(number);
    return known != null ? sequencer.rebuilt(known, number) : drawn(number);
  }

  private List<Trial> drawn(int number) {
    return sequencer
        .trials(turn, number)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "no order of the trials of the block %s keeps its limits of runs"
                        .formatted(block.name())));
  }

  /** Returns the trials of the present round, in order; of staircases those that are known. */
  public List<Trial> order() {
    return order;
  }

  /** Returns the next trial; empty when the block is over. */
  public Optional<Trial> next() {
    if (over) {
      return Optional.empty();
    }
    return staircases.isPresent()
        ? staircases.get().next(results.size() + 1)
        : Optional.of(order.get(inRound()));
  }

  private int inRound() {
    return (int) results.stream().filter(result -> result.round() == round).count();
  }

  /** Records the result of the next trial. */
  public void add(TrialResult result) {
    results.add(result);
    if (staircases.isPresent()) {
      staircases.get().answered(result.correct().orElse(false));
      over = staircases.get().over();
    } else if (inRound() >= order.size()) {
      boolean again =
          block
              .practice()
              .filter(criterion -> round < criterion.rounds() && !passed(criterion))
              .isPresent();
      if (again) {
        round++;
        order = round(round);
      }
      over = !again;
    }
  }

  private boolean passed(PracticeCriterion criterion) {
    List<TrialResult> last = results.stream().filter(result -> result.round() == round).toList();
    long correct = last.stream().filter(result -> result.correct().orElse(true)).count();
    return correct >= criterion.correct() * last.size() - 1e-9;
  }

  /** Returns whether the block is a practice that is over without having reached its criterion. */
  public boolean failed() {
    return over && block.practice().filter(criterion -> !passed(criterion)).isPresent();
  }

  /** Returns whether participants may rest before the next trial. */
  public boolean restIsDue() {
    return !over && block.rest() > 0 && inRound() > 0 && inRound() % block.rest() == 0;
  }

  /** Returns the present round of a practice block, from 1. */
  public int round() {
    return round;
  }

  /** Returns the number of finished trials. */
  public int done() {
    return results.size();
  }

  /** Returns the estimates of the staircases; none in other blocks. */
  public List<StaircaseEstimate> estimates() {
    return staircases.map(StaircaseTrials::estimates).orElse(List.of());
  }

  /**
   * The estimate of a staircase.
   *
   * @param levels the levels of the other factors
   * @param line line of its stimulus; 0 without a list
   * @param level mean level of the counting reversals, from 0; NaN if it did not converge
   * @param value mean of the levels' names, where all of them are numbers; else NaN
   * @param trials number of its trials
   */
  public record StaircaseEstimate(
      Map<String, String> levels, int line, double level, double value, int trials) {
    public StaircaseEstimate {
      levels = new LinkedHashMap<>(levels);
    }
  }
}
