package org.selectiverenderer.study.design;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of a finished trial.
 *
 * @param trial the trial's id
 * @param block name of its block
 * @param number its place in the block, from 1
 * @param round of a practice block, from 1
 * @param levels names of its levels by factor
 * @param line line of its stimulus in the list, from 1; 0 without a list
 * @param stimulus the cells of its stimulus, as they were then; empty without a list
 * @param response the key of the response; empty for none
 * @param milliseconds from the begin of the first phase with keys to the response
 * @param correct whether the response was correct; empty where none is wrong, and false where a
 *     response was missing
 */
public record TrialResult(
    String trial,
    String block,
    int number,
    int round,
    Map<String, String> levels,
    int line,
    Map<String, String> stimulus,
    String response,
    OptionalDouble milliseconds,
    Optional<Boolean> correct) {
  public TrialResult {
    levels = Map.copyOf(levels);
    stimulus = Map.copyOf(stimulus);
  }

  /** Returns the result of a trial with a response. */
  public static TrialResult of(
      Trial trial, String response, OptionalDouble milliseconds, Optional<Boolean> correct) {
    return new TrialResult(
        trial.id(),
        trial.block(),
        trial.number(),
        trial.round(),
        trial.levels(),
        trial.line(),
        trial.stimulus(),
        response,
        milliseconds,
        correct);
  }
}
