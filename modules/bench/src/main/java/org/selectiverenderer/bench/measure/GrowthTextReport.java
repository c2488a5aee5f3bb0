package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;

/** Formats the results of {@link GrowthBenchmark} as text: a table for each series. */
public final class GrowthTextReport {
  private static final String ROW = "%12s %9s %10s %10s %10s %10s %10s %11s %9s %9s%n";

  private GrowthTextReport() {}

  /** Returns several lines; the last one ends with a line feed. */
  public static String of(JsonNode report) {
    StringBuilder text = new StringBuilder();
    report
        .at("/growth")
        .properties()
        .forEach(
            series -> {
              row(
                  text,
                  series.getKey(),
                  "file: MB",
                  "load: ms",
                  "CPU: ms",
                  "heap: MB",
                  "frame: us",
                  "99 %: us",
                  "change: us",
                  "frames/s",
                  "MB");
              series.getValue().forEach(row -> row(text, row));
              text.append(System.lineSeparator());
            });
    text.append(
        String.format(
            Locale.ROOT,
            "CPU: loading, over all processors; frame: the update without drawing, the median"
                + " and what 99 of 100 keep to; change: an area is entered or left; MB: resident while drawing%n"));
    return text.toString();
  }

  private static void row(StringBuilder text, JsonNode row) {
    row(
        text,
        String.format(Locale.ROOT, "%,d", row.get("size").asInt()),
        figure(row, "/mb"),
        figure(row, "/load_ms"),
        figure(row, "/load_cpu_ms"),
        figure(row, "/heap_mb"),
        figure(row, "/frame_us"),
        figure(row, "/frame_p99_us"),
        figure(row, "/activation/us"),
        figure(row, "/fps"),
        figure(row, "/rss_mb"));
  }

  /** Formats a value, or a dash if it was not measured. */
  private static String figure(JsonNode row, String key) {
    JsonNode value = row.at(key);
    return value.isMissingNode() ? "-" : String.format(Locale.ROOT, "%,.1f", value.asDouble());
  }

  private static void row(StringBuilder text, Object... cells) {
    text.append(String.format(Locale.ROOT, ROW, cells));
  }
}
