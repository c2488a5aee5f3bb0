package org.selectiverenderer.study.design;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A trial of a participant.
 *
 * @param block name of its block
 * @param number its place in the block, from 1
 * @param round of a practice block, from 1; 1 for others
 * @param levels names of the levels by the names of the factors: those of the group, then those of
 *     the block
 * @param stimulus cells of its row of the stimulus list, by column; empty without a list
 * @param line line of that row in its file, from 1; 0 without a list
 * @param settings what it shows, with those of the participant's group
 * @param phases its phases, with all texts filled in
 */
public record Trial(
    String block,
    int number,
    int round,
    Map<String, String> levels,
    Map<String, String> stimulus,
    int line,
    TrialSettings settings,
    List<TrialPhase> phases) {
  public Trial {
    phases = List.copyOf(phases);
  }

  /** Returns the trial with other phases. */
  public Trial with(List<TrialPhase> others) {
    return new Trial(block, number, round, levels, stimulus, line, settings, others);
  }

  /** Returns what identifies the trial in a recorded order. */
  public TrialKey key() {
    return new TrialKey(levels, line);
  }

  /** Returns the id in the journal and in names of files. */
  public String id() {
    return round > 1
        ? String.format(Locale.ROOT, "%s-round%d-%03d", block, round, number)
        : String.format(Locale.ROOT, "%s-%03d", block, number);
  }

  /** Returns a text in which the trial's cells and levels replace {@code {column}}. */
  public String filled(String text) {
    String filled = text;
    if (text.indexOf('{') >= 0) {
      for (Map.Entry<String, String> level : levels.entrySet()) {
        filled = filled.replace("{" + level.getKey() + "}", level.getValue());
      }
      for (Map.Entry<String, String> cell : stimulus.entrySet()) {
        filled = filled.replace("{" + cell.getKey() + "}", cell.getValue());
      }
    }
    return filled;
  }
}
