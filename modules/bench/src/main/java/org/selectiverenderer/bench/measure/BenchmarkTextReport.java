package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;

/** Formats the results of the benchmark as text, beside those of other browsers. */
public final class BenchmarkTextReport {
  private static final String ROW = "%-42s %11s %9s %11s %11s %9s %11s%n";

  private static final String APARTMENT = "%-42s %11s %11s %11s%n";

  private BenchmarkTextReport() {}

  /** Returns several lines; the last one ends with a line feed. */
  public static String of(JsonNode report) {
    StringBuilder text = new StringBuilder();
    line(
        text,
        "machine     %s, %s processors",
        at(report, "/machine/processor"),
        at(report, "/machine/processors"));
    line(text, "java        %s", at(report, "/machine/java"));
    line(text, "OpenGL      %s, %s", at(report, "/gl/renderer"), at(report, "/gl/version"));
    line(
        text,
        "reading     %s MB/s over all processors (%s MB/s cold)",
        at(report, "/read/mb_per_s"),
        at(report, "/read/cold_mb_per_s"));
    line(
        text,
        "activation  %s us for a frame in which %s of %s switches change (%s us for "
            + "a frame without changes)",
        at(report, "/activation/us"),
        at(report, "/activation/affected"),
        at(report, "/activation/switches"),
        at(report, "/activation/idle_frame_us"));
    for (String scene : new String[] {"heavy", "light"}) {
      line(
          text,
          "yardstick   %s scene: %s frames/s of all triangles in one raw call; ours are %s times"
              + " as many",
          scene,
          at(report, "/" + scene + "/raw_fps"),
          at(report, "/" + scene + "/fps_to_raw"));
    }
    for (String at :
        new String[] {
          "/stereo/heavy",
          "/stereo/heavy/small_pictures",
          "/stereo/light",
          "/stereo/light/small_pictures"
        }) {
      line(
          text,
          "both eyes   %s scene, %sx%s each: %s ms for one eye, %s ms for both; the "
              + "second eye adds %s times the first",
          at.contains("heavy") ? "heavy" : "light",
          at(report, at + "/eye_width"),
          at(report, at + "/eye_height"),
          at(report, at + "/one_eye_ms"),
          at(report, at + "/both_eyes_ms"),
          at(report, at + "/second_eye_to_first"));
    }
    for (JsonNode row : report.at("/tracker_latency")) {
      line(
          text,
          row.has("skipped")
              ? "tracker     %s records/s: not measured, %s"
              : "tracker     %s records/s: record to picture: median %s ms, 99 of 100 "
                  + "within %s ms, longest %s ms (frames: %s and %s ms)",
          at(row, "/rate_hz"),
          row.has("skipped") ? at(row, "/skipped") : at(row, "/p50_ms"),
          at(row, "/p99_ms"),
          at(row, "/max_ms"),
          at(row, "/frame_p50_ms"),
          at(row, "/frame_p99_ms"));
    }
    text.append(System.lineSeparator());
    row(
        text,
        "1024x768, no anti-aliasing",
        "heavy: s",
        "frames/s",
        "MB",
        "light: s",
        "frames/s",
        "MB");
    row(
        text,
        "this program (from the start of reading)",
        seconds(report, "/heavy/load_ms"),
        at(report, "/heavy/fps"),
        at(report, "/heavy/rss_mb"),
        seconds(report, "/light/load_ms"),
        at(report, "/light/fps"),
        at(report, "/light/rss_mb"));
    row(
        text,
        "this program (from process start)",
        seconds(report, "/heavy/process_to_first_frame_ms"),
        "",
        "",
        seconds(report, "/light/process_to_first_frame_ms"),
        "",
        "");
    for (PeerBrowserResults.Peer peer : PeerBrowserResults.ALL) {
      row(
          text,
          peer.name(),
          peer.heavyLoad(),
          peer.heavyFps(),
          peer.heavyMemory(),
          peer.lightLoad(),
          peer.lightFps(),
          peer.lightMemory());
    }
    line(
        text,
        "The peers were measured on another machine of 4 cores with software OpenGL: compare with care.");
    if (report.has("versions")) {
      versions(text, report.get("versions"));
      bare(text, report.get("versions"));
    }
    if (report.has("apartment")) {
      apartment(text, report);
    }
    return text.toString();
  }

  private static void versions(StringBuilder text, JsonNode versions) {
    text.append(System.lineSeparator());
    text.append(
        String.format(
                Locale.ROOT,
                APARTMENT,
                "heavy scene, two versions of each object",
                "high",
                "selective",
                "ratio")
            .stripTrailing());
    text.append(System.lineSeparator());
    String[][] rows = {
      {"frames/s", "fps"},
      {"frame, ms", "frame_p50_ms"},
      {"processor time of a frame, ms", "cpu_ms"},
      {"of that, vertices, ms", "vertex_ms"},
      {"polygons drawn", "polygons_drawn"},
      {"polygons of the scene", "polygons"},
    };
    for (String[] row : rows) {
      double high = versions.at("/high/" + row[1]).asDouble();
      double selective = versions.at("/selective/" + row[1]).asDouble();
      String format = row[1].startsWith("polygons") ? "%,.0f" : "%,.1f";
      text.append(
          String.format(
              Locale.ROOT,
              APARTMENT,
              row[0],
              String.format(Locale.ROOT, format, high),
              String.format(Locale.ROOT, format, selective),
              String.format(Locale.ROOT, "%.2f", selective / high)));
    }
  }

  private static void bare(StringBuilder text, JsonNode versions) {
    line(
        text,
        "with a hundredth of the polygons: %s ms of processor time, of that vertices %s ms",
        at(versions, "/bare/cpu_ms"),
        at(versions, "/bare/vertex_ms"));
  }

  private static void radiosity(StringBuilder text, JsonNode report) {
    line(
        text,
        "radiosity   %s rays/s on one core among the apartment's %s triangles",
        at(report, "/radiosity/rays_per_s_per_core"),
        at(report, "/radiosity/triangles"));
    for (JsonNode hills : report.at("/radiosity/growth")) {
      line(
          text,
          "            %s rays/s over hills of %s",
          at(hills, "/rays_per_s_per_core"),
          at(hills, "/triangles"));
    }
  }

  private static void apartment(StringBuilder text, JsonNode report) {
    text.append(System.lineSeparator());
    line(
        text,
        "simplify    %s s for the %s objects of the apartment; %s s for %s triangles to %s",
        seconds(report, "/simplify/objects_ms"),
        at(report, "/simplify/objects"),
        seconds(report, "/simplify/large_ms"),
        at(report, "/simplify/large_triangles"),
        at(report, "/simplify/large_left"));
    if (report.has("radiosity")) {
      radiosity(text, report);
    }
    text.append(System.lineSeparator());
    text.append(
        String.format(
            Locale.ROOT, APARTMENT, "apartment, turning round", "high", "high-low", "selective"));
    String[][] rows = {
      {"frames/s", "fps"},
      {"polygons drawn", "polygons_drawn"},
      {"processor time of a frame, ms", "cpu_ms"},
      {"of that, vertices, ms", "vertex_ms"},
      {"first frame, ms", "first_frame_ms"},
      {"MB", "rss_mb"}
    };
    report
        .at("/apartment")
        .properties()
        .forEach(
            room -> {
              for (String[] row : rows) {
                text.append(
                    String.format(
                        Locale.ROOT,
                        APARTMENT,
                        room.getKey() + ", " + row[0],
                        figure(room.getValue(), "high", row[1]),
                        figure(room.getValue(), "high-low", row[1]),
                        figure(room.getValue(), "selective", row[1])));
              }
              line(
                  text,
                  "%s: selective draws %s times as many frames as high",
                  room.getKey(),
                  room.getValue().get("selective_to_high").asText());
            });
  }

  private static String figure(JsonNode room, String condition, String key) {
    String format = key.equals("vertex_ms") || key.equals("cpu_ms") ? "%,.1f" : "%,.0f";
    return String.format(Locale.ROOT, format, room.get(condition).get(key).asDouble());
  }

  private static String seconds(JsonNode report, String key) {
    return String.format(Locale.ROOT, "%.2f", report.at(key).asDouble() / 1000);
  }

  private static String at(JsonNode report, String key) {
    return report.at(key).asText();
  }

  private static void line(StringBuilder text, String format, Object... arguments) {
    text.append(String.format(Locale.ROOT, format, arguments)).append(System.lineSeparator());
  }

  private static void row(StringBuilder text, Object... cells) {
    text.append(String.format(Locale.ROOT, ROW, cells));
  }
}
