package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialKey;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.design.TrialSettings;
import org.selectiverenderer.study.session.LoadedStudy;

/**
 * Reads what the record of a trial tells of it. Levels must be those of the study; the cells of the
 * stimulus are those that the participant saw, also where the list has changed since.
 */
final class WebTrialParser {
  private static final int MOST_TRIALS = 1_000_000;
  private static final int MOST_ROUNDS = 100;
  private static final int MOST_PHASES = 10_000;
  private static final double LONGEST = 200_000;

  private final Study study;
  private final WebTrialPlan plan;
  private final Map<String, StimulusRows> rows = new HashMap<>();

  WebTrialParser(LoadedStudy material) throws IOException {
    study = material.study();
    plan = new WebTrialPlan(material);
    for (TrialBlock block : study.design().blocks()) {
      block.stimuli().ifPresent(list -> rows.put(block.name(), new StimulusRows(list)));
    }
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
    Map<String, String> cells = StimulusRows.cells(json.path("stimulus"));
    Trial trial =
        new TrialSequencer(block, own, study.seed())
            .recorded(
                new TrialKey(levels, line),
                present(cells, block),
                row(cells, block).map(StimulusList.Stimulus::settings).orElse(TrialSettings.NONE),
                number,
                round);
    require(
        trial.id().equals(json.path("step").asText()),
        "\"step\" is not the trial that \"block\", \"trial\" and \"round\" name");
    StimulusRows list = rows.get(block.name());
    plan.require(json, block, trial, list == null ? cells.isEmpty() : list.inPlace(line, cells));
    return Optional.of(trial);
  }

  private TrialBlock block(String name) {
    return study.design().blocks().stream()
        .filter(block -> block.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "the study has no block " + RecordFaults.quoted(name)));
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

  /** Returns the row with these cells; empty for none, and without a list. */
  private Optional<StimulusList.Stimulus> row(Map<String, String> cells, TrialBlock block) {
    StimulusRows list = rows.get(block.name());
    return list == null ? Optional.empty() : list.row(cells);
  }

  /** Returns the cells of the columns that the list has now, as tables have no others. */
  private static Map<String, String> present(Map<String, String> cells, TrialBlock block) {
    Map<String, String> present = new LinkedHashMap<>();
    block
        .stimuli()
        .ifPresent(
            list ->
                list.columns().stream()
                    .filter(cells::containsKey)
                    .forEach(column -> present.put(column, cells.get(column))));
    return present;
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
        response.isEmpty() == ms.isEmpty(),
        "\"ms\" is not the time of a response, in milliseconds");
    Optional<Boolean> correct =
        json.path("correct").isBoolean()
            ? Optional.of(json.path("correct").asBoolean())
            : Optional.empty();
    Map<String, String> cells = StimulusRows.cells(json.path("stimulus"));
    TrialBlock block = block(trial.block());
    boolean known = block.stimuli().isEmpty() ? cells.isEmpty() : row(cells, block).isPresent();
    return new WebRecord.TrialOutcome(
        TrialResult.of(trial, response, ms, correct), phases(json.path("phases")), known);
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
