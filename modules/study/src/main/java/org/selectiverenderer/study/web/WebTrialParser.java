package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialKey;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * Reads what the record of a trial tells of it. Levels must be those of the study; the cells of the
 * stimulus are those that the participant saw, also where the list has changed since.
 */
final class WebTrialParser {
  private static final int MOST_TRIALS = 1_000_000;
  private static final int MOST_ROUNDS = 100;
  private static final int MOST_PHASES = 10_000;
  private static final int LONGEST_CELL = 1000;
  private static final double LONGEST = 200_000;

  private final Study study;

  WebTrialParser(Study study) {
    this.study = study;
  }

  /**
   * Reads which trial it is.
   *
   * @param group name of the participant's group
   * @return empty if the record is not one of a trial
   * @throws IllegalArgumentException if it is not as the page writes it, with a sentence
   */
  Optional<Trial> trial(JsonNode json, String group) {
    if (!json.has("trial")) {
      return Optional.empty();
    }
    TrialBlock block = block(json.path("block").asText());
    StudyGroup own =
        study
            .design()
            .group(group)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "the study has no condition " + RecordFaults.quoted(group)));
    int number = whole(json, "trial", 1, MOST_TRIALS);
    int round = json.has("round") ? whole(json, "round", 1, MOST_ROUNDS) : 1;
    int line = json.has("line") ? whole(json, "line", 0, Integer.MAX_VALUE) : 0;
    Map<String, String> levels = levels(json.path("levels"), block, own);
    Trial trial =
        new TrialSequencer(block, own, study.seed())
            .recorded(
                new TrialKey(levels, line), stimulus(json.path("stimulus"), block), number, round);
    require(
        trial.id().equals(json.path("step").asText()),
        "\"step\" is not the trial that \"block\", \"trial\" and \"round\" name");
    return Optional.of(trial);
  }

  private TrialBlock block(String name) {
    return study.design().blocks().stream()
        .filter(block -> block.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException("the study has no block " + RecordFaults.quoted(name)));
  }

  private static Map<String, String> levels(JsonNode json, TrialBlock block, StudyGroup group) {
    Map<String, String> levels = new LinkedHashMap<>();
    for (Factor factor : block.factors()) {
      String level = json.path(factor.name()).asText();
      require(
          factor.level(level).isPresent(),
          "the factor %s has no level %s".formatted(factor.name(), RecordFaults.quoted(level)));
      levels.put(factor.name(), level);
    }
    group
        .levels()
        .forEach(
            (factor, level) ->
                require(
                    level.equals(json.path(factor).asText()),
                    "the level of %s is not that of the participant's condition"
                        .formatted(factor)));
    return levels;
  }

  private static Map<String, String> stimulus(JsonNode json, TrialBlock block) {
    Map<String, String> cells = new LinkedHashMap<>();
    if (block.stimuli().isPresent()) {
      for (String column : block.stimuli().get().columns()) {
        String cell = json.path(column).asText();
        require(
            cell.length() <= LONGEST_CELL && cell.chars().noneMatch(Character::isISOControl),
            "the cell %s of the stimulus is not one of a list".formatted(column));
        if (json.has(column)) {
          cells.put(column, cell);
        }
      }
    }
    return cells;
  }

  /**
   * Reads what came of a trial.
   *
   * @throws IllegalArgumentException if it is not as the page writes it, with a sentence
   */
  WebRecord.TrialOutcome outcome(JsonNode json, Trial trial) {
    String response = json.path("response").asText();
    Set<String> keys = new LinkedHashSet<>();
    trial.phases().forEach(phase -> addKeys(phase, keys));
    require(
        response.isEmpty() || keys.contains(response),
        "%s is no key of the trial (%s)"
            .formatted(RecordFaults.quoted(response), String.join(", ", keys)));
    OptionalDouble ms = WebRecordParser.number(json.path("ms"), 0, 1000 * LONGEST);
    require(
        response.isEmpty() == ms.isEmpty(), "\"ms\" is not the time of a response, in milliseconds");
    Optional<Boolean> correct =
        json.path("correct").isBoolean()
            ? Optional.of(json.path("correct").asBoolean())
            : Optional.empty();
    return new WebRecord.TrialOutcome(
        TrialResult.of(trial, response, ms, correct), phases(json.path("phases")));
  }

  private static void addKeys(TrialPhase phase, Set<String> keys) {
    if (phase instanceof TrialPhase.Exposure exposure) {
      keys.addAll(exposure.response().keys());
    } else if (phase instanceof TrialPhase.Blank blank) {
      keys.addAll(blank.response().keys());
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(inner -> addKeys(inner, keys));
    }
  }

  private static List<Map<String, Object>> phases(JsonNode json) {
    require(json.size() <= MOST_PHASES, "the trial has more than " + MOST_PHASES + " phases");
    List<Map<String, Object>> phases = new ArrayList<>();
    for (JsonNode one : json) {
      OptionalDouble began = WebRecordParser.number(one.path("began"), 0, LONGEST);
      OptionalDouble seconds = WebRecordParser.number(one.path("seconds"), 0, LONGEST);
      String name = one.path("phase").asText();
      require(
          began.isPresent() && seconds.isPresent() && name.matches("[a-z]{1,20}"),
          "phase %d of the trial is not as the page writes it".formatted(phases.size() + 1));
      Map<String, Object> members = new LinkedHashMap<>();
      members.put("phase", name);
      members.put("began", began.getAsDouble());
      members.put("seconds", seconds.getAsDouble());
      phases.add(members);
    }
    return phases;
  }

  private static int whole(JsonNode json, String key, int least, int most) {
    JsonNode value = json.path(key);
    require(
        value.isInt() && value.asInt() >= least && value.asInt() <= most,
        "\"%s\" is not a number from %d to %d".formatted(key, least, most));
    return value.asInt();
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
