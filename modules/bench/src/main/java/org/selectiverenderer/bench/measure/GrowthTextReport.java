package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;

/** Formats the results of {@link GrowthBenchmark} as text: two tables for each series. */
public final class GrowthTextReport {
  private static final String ROW = "%12s %9s %10s %10s %10s %10s %10s %11s %9s %9s%n";

  private static final Object[] STEPPED = {
    "file: MB",
    "load: ms",
    "CPU: ms",
    "heap: MB",
    "frame: us",
    "99 %: us",
    "change: us",
    "changed",
    "enriched"
  };

  private static final Object[] DRAWN = {
    "load: s", "first: s", "p50: ms", "p95: ms", "frames/s", "MB", "polygons", "drawn", ""
  };

  private GrowthTextReport() {}

  /** Returns several lines; the last one ends with a line feed. */
  public static String of(JsonNode report) {
    StringBuilder text = new StringBuilder();
    report
        .at("/growth")
        .properties()
        .forEach(
            series -> {
              row(text, series.getKey(), STEPPED);
              series.getValue().forEach(row -> stepped(text, row));
              row(text, "drawn", DRAWN);
              series.getValue().forEach(row -> drawn(text, row));
              text.append(System.lineSeparator());
            });
    line(
        text,
        "CPU: loading, over all processors; frame: the update without drawing, the median and what"
            + " 99 of 100 keep to; change: an area is entered or left, which changes so many of the"
            + " enriched objects");
    line(
        text,
        "drawn: in a process of its own, from the start of reading; MB: resident; polygons: of the"
            + " whole scene and, the mean, those that are drawn");
    return text.toString();
  }

  private static void stepped(StringBuilder text, JsonNode row) {
    if (row.has("skipped")) {
      line(text, size(row) + " not measured: " + row.get("skipped").asText());
      return;
    }
    row(
        text,
        size(row),
        figure(row, "/mb"),
        figure(row, "/load_ms"),
        figure(row, "/load_cpu_ms"),
        figure(row, "/heap_mb"),
        figure(row, "/frame_us"),
        figure(row, "/frame_p99_us"),
        figure(row, "/activation/us"),
        number(row, "/activation/changed"),
        number(row, "/enriched"));
  }

  private static void drawn(StringBuilder text, JsonNode row) {
    if (row.has("undrawn")) {
      line(text, size(row) + " not drawn: " + row.get("undrawn").asText());
    } else if (row.has("fps")) {
      row(
          text,
          size(row),
          seconds(row, "/loaded_ms"),
          seconds(row, "/first_frame_ms"),
          figure(row, "/frame_p50_ms"),
          figure(row, "/frame_p95_ms"),
          figure(row, "/fps"),
          figure(row, "/rss_mb"),
          number(row, "/polygons"),
          number(row, "/polygons_drawn"),
          "");
    }
  }

  private static String size(JsonNode row) {
    return String.format(Locale.ROOT, "%,12d", row.get("size").asInt());
  }

  /** Formats a value, or a dash if it was not measured. */
  private static String figure(JsonNode row, String key) {
    return formatted(row, key, "%,.1f", 1);
  }

  private static String number(JsonNode row, String key) {
    return formatted(row, key, "%,.0f", 1);
  }

  private static String seconds(JsonNode row, String key) {
    return formatted(row, key, "%,.2f", 1_000);
  }

  private static String formatted(JsonNode row, String key, String format, double unit) {
    JsonNode value = row.at(key);
    return value.isMissingNode()
        ? "-"
        : String.format(Locale.ROOT, format, value.asDouble() / unit);
  }

  private static void row(StringBuilder text, String first, Object... cells) {
    Object[] all = new Object[cells.length + 1];
    all[0] = first;
    System.arraycopy(cells, 0, all, 1, cells.length);
    text.append(String.format(Locale.ROOT, ROW, all).stripTrailing());
    text.append(System.lineSeparator());
  }

  private static void line(StringBuilder text, String line) {
    text.append(line).append(System.lineSeparator());
  }
}
