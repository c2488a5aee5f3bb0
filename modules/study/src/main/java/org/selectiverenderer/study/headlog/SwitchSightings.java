package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * The changes of versions that a time line ({@code run --timeline}) or the journal of a session
 * tells, and what the viewer saw of them.
 *
 * @param changes in the order of the time line
 */
public record SwitchSightings(List<Change> changes) {
  private static final int MOST_CHANGES = 1_000_000;
  private static final long MOST_BYTES = 256L << 20;

  /**
   * A change of a version.
   *
   * @param t seconds since the begin of the run
   * @param object the DEF of the Switch
   * @param visible whether the object was seen as it changed
   * @param pixels estimated number of pixels that showed it
   * @param turning rate at which the view turned, in degrees per second
   */
  public record Change(double t, String object, boolean visible, long pixels, double turning) {}

  /** The changes of one object. */
  private record Sum(int changes, int visible, long pixels) {
    Sum with(Change change) {
      return new Sum(
          changes + 1, visible + (change.visible() ? 1 : 0), Math.max(pixels, change.pixels()));
    }
  }

  /** Copies the changes. */
  public SwitchSightings {
    changes = List.copyOf(changes);
  }

  /**
   * Reads a time line. Lines that cannot be read are reported and left out, as are changes that do
   * not tell whether they were seen, which older programs wrote.
   *
   * @throws IOException with a one-line message, if the file cannot be read
   */
  public static SwitchSightings read(Path file, ProblemCollector problems) throws IOException {
    List<Change> changes = new ArrayList<>();
    int number = 0;
    if (Files.size(file) > MOST_BYTES) {
      throw new IOException(file + ": is larger than 256 MB, which no time line is");
    }
    try (BufferedReader lines = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        number++;
        SourceLocation place = new SourceLocation(file.toString(), number, 1);
        JsonNode event = parsed(line, place, problems);
        if (!event.path("event").asText().equals("switch")) {
          continue;
        }
        if (!event.path("visible").isBoolean()) {
          problems.warning(place, "the time line does not tell whether the change was seen");
        } else if (changes.size() == MOST_CHANGES) {
          throw new IOException(file + ": has more than " + MOST_CHANGES + " changes of versions");
        } else {
          changes.add(change(event));
        }
      }
    } catch (CharacterCodingException e) {
      throw new IOException(file + ": is not a time line in UTF-8", e);
    }
    return new SwitchSightings(changes);
  }

  /**
   * Returns the changes among the events of a time line; changes that do not tell whether they were
   * seen are left out.
   */
  public static SwitchSightings of(List<JsonNode> events) {
    return new SwitchSightings(
        events.stream()
            .filter(event -> event.path("event").asText().equals("switch"))
            .filter(event -> event.path("visible").isBoolean())
            .map(SwitchSightings::change)
            .toList());
  }

  private static JsonNode parsed(String line, SourceLocation place, ProblemCollector problems) {
    try {
      return JsonTree.parse(line);
    } catch (JsonProcessingException e) {
      problems.error(place, "is no line of a time line: " + JsonTree.sentence(e));
      return JsonTree.object();
    }
  }

  private static Change change(JsonNode event) {
    return new Change(
        event.path("t").asDouble(),
        event.path("switch").asText(),
        event.path("visible").asBoolean(),
        Math.max(0, event.path("pixels").asLong()),
        event.path("turning").asDouble());
  }

  /** Returns the number of changes that were seen. */
  public long visible() {
    return changes.stream().filter(Change::visible).count();
  }

  private Map<String, Sum> objects() {
    Map<String, Sum> sums = new LinkedHashMap<>();
    for (Change change : changes) {
      sums.put(change.object(), sums.getOrDefault(change.object(), new Sum(0, 0, 0)).with(change));
    }
    return sums;
  }

  /** Returns a table for people: a row for each object; several lines, the last one ended. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append("%-32s %8s %8s %10s\n".formatted("versions", "changes", "visible", "pixels"));
    objects()
        .forEach(
            (object, sum) ->
                text.append(
                    String.format(
                        Locale.ROOT,
                        "%-32s %8d %8d %10s\n",
                        object,
                        sum.changes(),
                        sum.visible(),
                        sum.visible() == 0 ? "" : sum.pixels())));
    text.append(
        "%s, %d of them visible\n".formatted(Pluralizer.of(changes.size(), "change"), visible()));
    return text.toString();
  }

  /** Adds the changes to a report: {@code switches}. */
  void put(ObjectNode report) {
    ArrayNode all = report.putArray("switches");
    for (Change change : changes) {
      all.addObject()
          .put("t", DecimalRounding.to(6, change.t()))
          .put("object", change.object())
          .put("visible", change.visible())
          .put("pixels", change.pixels())
          .put("turning", DecimalRounding.to(1, change.turning()));
    }
  }
}
