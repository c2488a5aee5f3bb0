package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.statistics.detection.EmpiricalRoc;
import org.selectiverenderer.statistics.detection.UnequalVarianceFit;
import org.selectiverenderer.statistics.study.RatingAnalysis;

/** Writes analyses of ratings as JSON; docs/statistics.md lists the keys. */
final class RatingsJsonWriter {
  private RatingsJsonWriter() {}

  static void write(RatingAnalysis score, ObjectNode json) {
    json.put("area", score.area()).put("condition", score.condition());
    json.put("participant", score.participant().orElse(null));
    json.put("object_type", score.type()).put("participants", score.participants());
    score.ratings().signal().forEach(json.putArray("present")::add);
    score.ratings().noise().forEach(json.putArray("absent")::add);
    ArrayNode points = json.putArray("roc");
    for (EmpiricalRoc.Point point : score.roc().points()) {
      ObjectNode node = points.addObject();
      JsonNumbers.put(node, "false_alarm_rate", point.falseAlarmRate());
      JsonNumbers.put(node, "hit_rate", point.hitRate());
    }
    JsonNumbers.put(json, "auc", score.roc().area());
    JsonNumbers.put(json, "auc_se", score.roc().standardError());
    UnequalVarianceFit fit = score.fit();
    estimate(json, "d_a", fit.distance());
    estimate(json, "a_z", fit.area());
    estimate(json, "intercept", fit.intercept());
    estimate(json, "slope", fit.slope());
    ArrayNode criteria = json.putArray("criteria");
    for (UnequalVarianceFit.Estimate criterion : fit.criteria()) {
      estimate(criteria.addObject(), "c", criterion);
    }
    JsonNumbers.put(json, "g2", fit.g2());
    json.put("g2_df", fit.df());
    JsonNumbers.put(json, "g2_p", fit.fitP());
    JsonNumbers.put(json, "slope_p", fit.slopeP());
    if (fit.equal().isPresent()) {
      ObjectNode equal = json.putObject("equal_variance");
      estimate(equal, "d_prime", fit.equal().get().dPrime());
      JsonNumbers.put(equal, "g2", fit.equal().get().g2());
      equal.put("g2_df", fit.df() + 1);
    } else {
      json.putNull("equal_variance");
    }
    fit.flaw().ifPresent(flaw -> json.put("undefined", flaw));
  }

  private static void estimate(ObjectNode json, String key, UnequalVarianceFit.Estimate estimate) {
    JsonNumbers.put(json, key, estimate.value());
    JsonNumbers.put(json, key + "_se", estimate.standardError());
  }
}
