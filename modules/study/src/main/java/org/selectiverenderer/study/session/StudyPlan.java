package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.study.definition.AreaOrder;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * The plan of a study: the group of each place of the randomization schedule, and what a
 * participant at this place is shown, in order. It is the order that the session will have.
 *
 * @param places the places, from the first one
 * @param next number of the place of the next participant, from 1
 * @param faults sentences about orders that do not exist
 */
public record StudyPlan(Study study, List<Place> places, int next, List<String> faults) {
  /** More trials take too much memory. */
  private static final int MOST_TRIALS = 2_000_000;

  /** Name of the only block of a study without blocks, whose trials are the areas. */
  public static final String AREAS = "areas";

  /**
   * A place of the schedule.
   *
   * @param number from 1
   * @param participant the participant who has the place; empty while it is free
   */
  public record Place(
      int number, Optional<String> participant, StudyGroup group, List<Block> blocks) {
    public Place {
      blocks = List.copyOf(blocks);
    }
  }

  /**
   * A block of trials at a place.
   *
   * @param open why the order is not known before the session; empty where it is known
   */
  public record Block(String name, List<PlannedTrial> trials, Optional<String> open) {
    public Block {
      trials = List.copyOf(trials);
    }
  }

  /**
   * A trial of the plan.
   *
   * @param levels the levels of the factors within participants
   * @param line line of its stimulus in the list; 0 without a list
   * @param stimulus the cells of its stimulus
   */
  public record PlannedTrial(
      int number, Map<String, String> levels, int line, Map<String, String> stimulus) {
    /** Returns the levels, with a plus between them; the stimulus's line where there are none. */
    public String combination() {
      return levels.isEmpty()
          ? line > 0 ? "line " + line : "trial"
          : String.join("+", levels.values());
    }
  }

  public StudyPlan {
    places = List.copyOf(places);
    faults = List.copyOf(faults);
  }

  /**
   * Makes the plan of the first places.
   *
   * @param number how many places, at least 1
   * @throws IOException if the file of the participants cannot be read, or the plan is too long
   */
  public static StudyPlan of(Study study, int number) throws IOException {
    Map<Integer, String> taken = new HashMap<>();
    new ParticipantsFile(study).all().forEach(row -> taken.put(row.place(), row.participant()));
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    Map<String, Integer> turns = new HashMap<>();
    List<Place> places = new ArrayList<>();
    List<String> faults = new ArrayList<>();
    long planned = 0;
    for (int place = 1; place <= number; place++) {
      StudyGroup group = schedule.group(place);
      int turn = turns.merge(group.name(), 1, Integer::sum) - 1;
      Optional<String> participant = Optional.ofNullable(taken.get(place));
      List<Block> blocks = new ArrayList<>();
      for (TrialBlock block : study.design().blocks()) {
        blocks.add(block(study, block, group, turn, place, faults));
      }
      if (study.design().blocks().isEmpty() && !study.areas().isEmpty()) {
        blocks.add(areas(study, participant, turn));
      }
      places.add(new Place(place, participant, group, blocks));
      planned += blocks.stream().mapToLong(block -> block.trials().size()).sum();
      if (planned > MOST_TRIALS) {
        throw new IOException(
            "%s: the plan of %d places has more than %d trials; plan fewer places"
                .formatted(study.file(), number, MOST_TRIALS));
      }
    }
    return new StudyPlan(study, places, schedule.free(taken.keySet(), Optional.empty()), faults);
  }

  private static Block block(
      Study study, TrialBlock block, StudyGroup group, int turn, int place, List<String> faults) {
    if (block.staircase().isPresent()) {
      return new Block(
          block.name(), List.of(), Optional.of("the staircase chooses each trial by the answers"));
    }
    Optional<List<Trial>> trials = new TrialSequencer(block, group, study.seed()).trials(turn, 1);
    if (trials.isEmpty()) {
      faults.add(
          ("no order of the trials of the block %s keeps \"at_most_in_a_row\" for the participant at"
                  + " place %d; allow more in a row")
              .formatted(block.name(), place));
    }
    return new Block(
        block.name(),
        trials.orElse(List.of()).stream().map(trial -> planned(trial, group)).toList(),
        Optional.empty());
  }

  private static PlannedTrial planned(Trial trial, StudyGroup group) {
    Map<String, String> within = new LinkedHashMap<>(trial.levels());
    within.keySet().removeAll(group.levels().keySet());
    return new PlannedTrial(trial.number(), within, trial.line(), trial.stimulus());
  }

  private static Block areas(Study study, Optional<String> participant, int turn) {
    if (study.course().order() == AreaOrder.RANDOM && participant.isEmpty()) {
      return new Block(
          AREAS, List.of(), Optional.of("the order is drawn from the participant's id"));
    }
    List<PlannedTrial> trials = new ArrayList<>();
    for (Study.Area area : AreaSequence.of(study, participant.orElse(""), turn)) {
      trials.add(new PlannedTrial(trials.size() + 1, Map.of("area", area.name()), 0, Map.of()));
    }
    return new Block(AREAS, trials, Optional.empty());
  }
}
