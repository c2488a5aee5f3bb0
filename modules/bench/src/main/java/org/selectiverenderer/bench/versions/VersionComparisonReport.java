package org.selectiverenderer.bench.versions;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;

/** Formats the results of {@link VersionComparison} as text: a table for each scene. */
public final class VersionComparisonReport {
  private VersionComparisonReport() {}

  /**
   * Returns several lines; the last one ends with a line feed.
   *
   * @param report an object of scenes by name
   */
  public static String of(JsonNode report) {
    StringBuilder text = new StringBuilder();
    report
        .properties()
        .forEach(
            scene -> {
              JsonNode figures = scene.getValue();
              text.append(
                  String.format(
                      Locale.ROOT,
                      "%s: %d poses, %,d triangles with all objects high%n",
                      scene.getKey(),
                      figures.get("poses").asInt(),
                      figures.get("triangles_high").asLong()));
              row(text, "at the thesis's triangles", "thesis", figures.get("thesis"));
              figures
                  .get("at_the_thesis_triangles")
                  .properties()
                  .forEach(rule -> row(text, "", rule.getKey(), rule.getValue()));
              figures
                  .get("rules")
                  .properties()
                  .forEach(
                      rule -> {
                        for (JsonNode budget : rule.getValue()) {
                          row(text, "at shares of the rest", rule.getKey(), budget);
                        }
                      });
            });
    text.append(
        String.format(
            "unlike: 1 - SSIM of a picture and that with all objects high, the mean of the poses;"
                + " least loss: the budget without consistency%n"));
    return text.toString();
  }

  private static void row(StringBuilder text, String group, String rule, JsonNode figures) {
    text.append(
        String.format(
            Locale.ROOT,
            "  %-26s %-14s %,10d triangles  unlike %.5f%n",
            group,
            rule,
            figures.get("triangles").asLong(),
            figures.get("unlike").asDouble()));
  }
}
