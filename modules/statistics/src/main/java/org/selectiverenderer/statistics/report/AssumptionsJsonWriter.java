package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.selectiverenderer.statistics.assumption.AssumptionChecks;
import org.selectiverenderer.statistics.assumption.LeveneTest;
import org.selectiverenderer.statistics.assumption.Outlier;
import org.selectiverenderer.statistics.assumption.ShapiroWilkTest;

/** Writes the assumption checks of an analysis as JSON; docs/statistics.md lists the keys. */
final class AssumptionsJsonWriter {
  private AssumptionsJsonWriter() {}

  static void write(AssumptionChecks found, ObjectNode json) {
    ArrayNode levene = json.putArray("levene");
    for (LeveneTest test : found.levene()) {
      ObjectNode node = levene.addObject().put("at", test.at().orElse(null));
      fTest(test.f(), test.df1(), test.df2(), test.p(), node);
    }
    found
        .box()
        .ifPresent(
            test -> {
              ObjectNode node = json.putObject("box_m");
              JsonNumbers.put(node, "m", test.m());
              JsonNumbers.put(node, "chi2", test.chiSquared());
              JsonNumbers.put(node, "df", test.df());
              JsonNumbers.put(node, "p", test.p());
            });
    ArrayNode shapiro = json.putArray("shapiro_wilk");
    for (ShapiroWilkTest test : found.shapiro()) {
      ObjectNode node = shapiro.addObject().put("at", test.at().orElse(null));
      JsonNumbers.put(node, "W", test.w());
      JsonNumbers.put(node, "p", test.p());
    }
    ArrayNode outliers = json.putArray("outliers");
    for (Outlier outlier : found.outliers()) {
      ObjectNode node = outliers.addObject().put("participant", outlier.participant());
      node.put("at", outlier.at().orElse(null));
      JsonNumbers.put(node, "value", outlier.value());
      JsonNumbers.put(node, "studentised_residual", outlier.studentised());
      JsonNumbers.put(node, "p_bonferroni", outlier.p());
    }
    found
        .welch()
        .ifPresent(
            test -> fTest(test.f(), test.df1(), test.df2(), test.p(), json.putObject("welch")));
    found.consequences().forEach(json.putArray("consequences")::add);
  }

  private static void fTest(double f, double df1, double df2, double p, ObjectNode json) {
    JsonNumbers.put(json, "F", f);
    JsonNumbers.put(json, "df1", df1);
    JsonNumbers.put(json, "df2", df2);
    JsonNumbers.put(json, "p", p);
  }
}
