package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * A session that is planned before its participant is known, for a program that shows it elsewhere:
 * it is the session that this program would run for a participant of this id at this place.
 *
 * @param place of the randomization schedule, from 1
 * @param participant the place as an id, such as {@code 007}, from which random orders are drawn
 * @param group the group of the place
 * @param turn index of the place among those of its group, from 0
 * @param steps the steps in order
 */
public record PlannedSession(
    int place, String participant, StudyGroup group, int turn, List<SessionStep> steps) {
  public PlannedSession {
    steps = List.copyOf(steps);
  }

  /**
   * Returns the trials of a round of a block, in order, as this program would run them.
   *
   * @param round of a practice block, from 1
   * @throws IllegalArgumentException if no order keeps the block's limits of runs, with a sentence
   */
  public List<Trial> trials(Study study, TrialBlock block, int round) {
    return new TrialSequencer(block, group, study.seed())
        .trials(turn, round)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    ("no order of the trials of the block %s (place %d of the plan, round %d) keeps"
                            + " its limits of runs; allow longer ones by \"at_most_in_a_row\"")
                        .formatted(block.name(), place, round)));
  }

  /** Returns the sessions of all planned participants of a study, in the order of the schedule. */
  public static List<PlannedSession> all(LoadedStudy material) {
    Study study = material.study();
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    Map<String, Integer> turns = new HashMap<>();
    List<PlannedSession> sessions = new ArrayList<>();
    for (int place = 1; place <= study.participants(); place++) {
      StudyGroup group = schedule.group(place);
      int turn = turns.merge(group.name(), 1, Integer::sum) - 1;
      String participant = String.format(Locale.ROOT, "%03d", place);
      sessions.add(
          new PlannedSession(
              place,
              participant,
              group,
              turn,
              material.steps(AreaSequence.of(study, participant, turn))));
    }
    return sessions;
  }
}
