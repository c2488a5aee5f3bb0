package org.selectiverenderer.study.session;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialKey;
import org.selectiverenderer.study.design.TrialResult;

/** Writes trials into events of the journal, and reads them from there. */
public final class TrialEvents {
  private TrialEvents() {}

  /** Returns the members that the begin and the end of a trial have. */
  public static Map<String, Object> members(Trial trial) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("block", trial.block());
    members.put("trial", trial.number());
    if (trial.round() > 1) {
      members.put("round", trial.round());
    }
    members.put("levels", trial.levels());
    if (trial.line() > 0) {
      members.put("line", trial.line());
      members.put("stimulus", trial.stimulus());
    }
    return members;
  }

  /** Returns the members of a result, in addition to those of the trial. */
  public static Map<String, Object> members(TrialResult result) {
    Map<String, Object> members = new LinkedHashMap<>();
    if (!result.response().isEmpty()) {
      members.put("response", result.response());
    }
    result.milliseconds().ifPresent(ms -> members.put("ms", DecimalRounding.to(1, ms)));
    result.correct().ifPresent(correct -> members.put("correct", correct));
    return members;
  }

  /** Returns the members of the order of a round's trials. */
  public static Map<String, Object> order(String block, int round, List<Trial> trials) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("step", block);
    members.put("round", round);
    members.put(
        "trials",
        trials.stream()
            .map(
                trial -> {
                  Map<String, Object> key = new LinkedHashMap<>();
                  key.put("levels", trial.levels());
                  if (trial.line() > 0) {
                    key.put("line", trial.line());
                  }
                  return key;
                })
            .toList());
    return members;
  }

  /** Reads an order. */
  static List<TrialKey> order(JsonNode event) {
    List<TrialKey> keys = new ArrayList<>();
    event
        .path("trials")
        .forEach(
            trial ->
                keys.add(new TrialKey(texts(trial.path("levels")), trial.path("line").asInt())));
    return keys;
  }

  /** Reads the result of a trial; empty for the end of another step. */
  static Optional<TrialResult> result(JsonNode event) {
    if (!event.has("block") || !event.has("trial")) {
      return Optional.empty();
    }
    return Optional.of(
        new TrialResult(
            event.path("step").asText(),
            event.path("block").asText(),
            event.path("trial").asInt(),
            event.path("round").asInt(1),
            texts(event.path("levels")),
            event.path("line").asInt(),
            texts(event.path("stimulus")),
            event.path("response").asText(""),
            event.has("ms")
                ? OptionalDouble.of(event.path("ms").asDouble())
                : OptionalDouble.empty(),
            event.has("correct")
                ? Optional.of(event.path("correct").asBoolean())
                : Optional.empty()));
  }

  private static Map<String, String> texts(JsonNode object) {
    Map<String, String> texts = new LinkedHashMap<>();
    object.properties().forEach(field -> texts.put(field.getKey(), field.getValue().asText()));
    return texts;
  }
}
