package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.study.session.StudyChecksums;

/**
 * Refuses trials that the plan does not have, which no page sends. Only records of the study as it
 * is now are held against it, and of rows that its lists still have: all others had another plan.
 */
final class WebTrialPlan {
  /** Rounds whose orders are kept, as records of a session follow one another. */
  private static final int KEPT = 16;

  private final LoadedStudy material;
  private final String checksum;
  private final Map<Integer, PlannedSession> places = new HashMap<>();
  private final Map<List<Object>, Optional<List<Trial>>> orders = new LinkedHashMap<>();

  WebTrialPlan(LoadedStudy material) throws IOException {
    this.material = material;
    checksum = StudyChecksums.ofStudyFile(material);
    PlannedSession.all(material).forEach(session -> places.put(session.place(), session));
  }

  /**
   * Refuses a trial that is not in the plan.
   *
   * @param json its record
   * @param inPlace whether the list has the row of its stimulus at the line where it was
   * @throws IllegalArgumentException if it is not, with a sentence
   */
  void require(JsonNode json, TrialBlock block, Trial trial, boolean inPlace) {
    if (!checksum.equals(json.path("checksum").asText()) || block.staircase().isPresent()) {
      return;
    }
    int rounds = block.practice().map(TrialBlock.PracticeCriterion::rounds).orElse(1);
    if (trial.round() > rounds) {
      throw new IllegalArgumentException(
          "the block %s has no round %d".formatted(block.name(), trial.round()));
    }
    PlannedSession planned = places.get(json.path("slot").asInt());
    boolean own = planned != null && planned.group().name().equals(json.path("group").asText());
    Optional<List<Trial>> drawn =
        own && inPlace ? order(planned, block, trial.round()) : Optional.empty();
    if (drawn.isEmpty()) {
      return;
    }
    List<Trial> order = drawn.get();
    if (trial.number() > order.size()) {
      throw new IllegalArgumentException(
          ("the block %s has no trial %d, only %d; if its list of stimuli has lost rows, put them"
                  + " back")
              .formatted(block.name(), trial.number(), order.size()));
    }
    // A row that was added to the list since has changed the order, but not the row itself.
    List<Trial> possible =
        block.stimuli().isPresent() ? order : List.of(order.get(trial.number() - 1));
    if (possible.stream().noneMatch(each -> each.key().equals(trial.key()))) {
      throw new IllegalArgumentException(
          "the participant's plan has another trial %d of the block %s"
              .formatted(trial.number(), block.name()));
    }
  }

  private Optional<List<Trial>> order(PlannedSession planned, TrialBlock block, int round) {
    List<Object> key = List.of(planned.place(), block.name(), round);
    Optional<List<Trial>> known = orders.get(key);
    if (known != null) {
      return known;
    }
    if (orders.size() >= KEPT) {
      orders.clear();
    }
    Optional<List<Trial>> drawn = drawn(planned, block, round);
    orders.put(key, drawn);
    return drawn;
  }

  private Optional<List<Trial>> drawn(PlannedSession planned, TrialBlock block, int round) {
    try {
      return Optional.of(planned.trials(material.study(), block, round));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // The list has changed so that no order is left.
    }
  }
}
