package org.selectiverenderer.export.study;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialPhase.ResponseKeys;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;

/**
 * Describes blocks of trials for the page: each different trial once, what its phases are, and for
 * each place of the plan the order of the trials in each round.
 */
final class TrialDescription {
  private final LoadedStudy material;
  private final Study study;
  private final Map<Path, String> scenes;
  private final Map<List<Object>, Integer> known = new LinkedHashMap<>();
  private final ArrayNode trials;

  /**
   * Prepares the description.
   *
   * @param scenes names of the exported scenes by their files
   * @param trials receives the different trials
   */
  TrialDescription(LoadedStudy material, Map<Path, String> scenes, ArrayNode trials) {
    this.material = material;
    this.scenes = scenes;
    this.trials = trials;
    study = material.study();
  }

  /** Describes a block as a step. */
  static void describe(TrialBlock block, ObjectNode json) {
    json.put("kind", "block");
    json.put("rest", block.rest());
    block
        .practice()
        .ifPresent(
            criterion -> {
              ObjectNode practice = json.putObject("practice");
              practice.put("correct", criterion.correct());
              practice.put("rounds", criterion.rounds());
            });
  }

  /** Describes the phases of a block's trials, with {@code {column}} for cells and levels. */
  static void phases(List<TrialPhase> phases, ArrayNode json) {
    phases.forEach(phase -> phase(phase, json.addObject()));
  }

  private static void phase(TrialPhase phase, ObjectNode json) {
    if (phase instanceof TrialPhase.Instruction instruction) {
      json.put("show", "instruction");
      json.put("text", instruction.text());
    } else if (phase instanceof TrialPhase.Fixation fixation) {
      json.put("show", "fixation");
      json.put("seconds", fixation.seconds());
    } else if (phase instanceof TrialPhase.Exposure exposure) {
      json.put("show", "exposure");
      seconds(exposure.seconds(), json);
      // Sorted, so that the same study is always the same text.
      new TreeMap<>(exposure.choices()).forEach(json.putObject("choices")::put);
      response(exposure.response(), json);
    } else if (phase instanceof TrialPhase.Blank blank) {
      json.put("show", "blank");
      seconds(blank.seconds(), json);
      response(blank.response(), json);
    } else if (phase instanceof TrialPhase.Questions questions) {
      json.put("show", "questions");
      json.put("questionnaire", questions.questionnaire());
    } else if (phase instanceof TrialPhase.Feedback feedback) {
      json.put("show", "feedback");
      json.put("seconds", feedback.seconds());
      json.put("correct", feedback.correct());
      json.put("wrong", feedback.wrong());
      json.put("missing", feedback.missing());
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      json.put("show", "repeat");
      json.put("most", repeat.most());
      phases(repeat.phases(), json.putArray("phases"));
    }
  }

  private static void seconds(OptionalDouble seconds, ObjectNode json) {
    seconds.ifPresent(duration -> json.put("seconds", duration));
  }

  private static void response(ResponseKeys response, ObjectNode json) {
    if (!response.keys().isEmpty()) {
      response.keys().forEach(json.putArray("keys")::add);
      json.put("correct", response.correct());
    }
  }

  /**
   * Describes the order of a participant's trials: for each block a list of rounds, of which each
   * is a list of indices of trials.
   */
  void orders(PlannedSession session, ObjectNode json) {
    for (TrialBlock block : study.design().blocks()) {
      ArrayNode rounds = json.putArray(block.name());
      int most = block.practice().map(TrialBlock.PracticeCriterion::rounds).orElse(1);
      for (int round = 1; round <= most; round++) {
        ArrayNode order = rounds.addArray();
        session.trials(study, block, round).forEach(trial -> order.add(index(trial)));
      }
    }
  }

  private int index(Trial trial) {
    List<Object> content =
        List.of(trial.block(), trial.levels(), trial.line(), trial.settings(), trial.stimulus());
    Integer before = known.get(content);
    if (before != null) {
      return before;
    }
    known.put(content, known.size());
    describe(trial, trials.addObject());
    return known.size() - 1;
  }

  private void describe(Trial trial, ObjectNode json) {
    json.put("block", trial.block());
    trial.levels().forEach(json.putObject("levels")::put);
    if (trial.line() > 0) {
      json.put("line", trial.line());
      trial.stimulus().forEach(json.putObject("stimulus")::put);
    }
    json.put("scene", scenes.getOrDefault(scene(material, trial), ""));
    json.put("viewpoint", study.viewpoint(trial).orElse(""));
    json.put(
        "condition", trial.settings().condition().orElse(Condition.SELECTIVE).spelling());
    new TreeMap<>(trial.settings().choices()).forEach(json.putObject("choices")::put);
    trial.settings().headlight().ifPresent(on -> json.put("light", on));
    seconds(study.seconds(trial, new TrialPhase.Exposure(
        OptionalDouble.empty(), Map.of(), ResponseKeys.NONE, false)), json);
    json.put(
        "stay",
        trial
            .settings()
            .area()
            .flatMap(study::area)
            .map(study::stay)
            .orElse(study.course().stay())
            .spelling());
  }

  /** Returns the scene that a trial is shown in, as the program itself chooses it. */
  static Path scene(LoadedStudy material, Trial trial) {
    return material
        .study()
        .scene(trial)
        .or(material::scenery)
        .orElseThrow(() -> new IllegalArgumentException(material.lackingScene().orElse("")));
  }
}
