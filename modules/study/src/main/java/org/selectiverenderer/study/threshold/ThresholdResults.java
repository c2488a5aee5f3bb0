package org.selectiverenderer.study.threshold;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.threshold.ThresholdEstimate.Kind;

/**
 * The thresholds of all objects over the participants of a pilot.
 *
 * @param participants number of participants who count
 * @param objects the thresholds, in the order of the settings
 */
public record ThresholdResults(
    ThresholdStudy study, int participants, List<ObjectThreshold> objects) {
  public ThresholdResults {
    objects = List.copyOf(objects);
  }

  /**
   * Reads the logs of all participants.
   *
   * @param problems receives who is left out for too many missed catch trials, and whose trials are
   *     not over
   * @throws IOException if a log cannot be read
   */
  public static ThresholdResults read(ThresholdStudy study, ProblemCollector problems)
      throws IOException {
    List<JsonNode> counting = new ArrayList<>();
    Map<String, List<String>> shown = new LinkedHashMap<>();
    int participants = 0;
    for (Path folder : folders(study)) {
      List<JsonNode> events = TrialLog.read(folder, problems);
      if (!events.isEmpty() && attends(study, folder, events, problems)) {
        counting.addAll(events);
        participants++;
        events.stream()
            .filter(event -> is(event, "pilot-began"))
            .map(event -> event.path("material_sha256").asText())
            .forEach(
                sum ->
                    shown
                        .computeIfAbsent(sum, same -> new ArrayList<>())
                        .add(folder.getFileName().toString()));
      }
    }
    if (shown.size() > 1) {
      problems.warning(
          SourceLocation.of(study.file().toString()),
          ("the settings or the pictures were changed between participants (%s); their results"
                  + " are not comparable, and should not be averaged")
              .formatted(
                  shown.values().stream()
                      .map(same -> String.join(", ", same))
                      .collect(Collectors.joining("; "))));
    }
    List<ObjectThreshold> objects = new ArrayList<>();
    for (ThresholdStudy.Judged judged : study.objects()) {
      objects.add(of(judged.object(), counting));
    }
    return new ThresholdResults(study, participants, objects);
  }

  private static List<Path> folders(ThresholdStudy study) throws IOException {
    if (!Files.isDirectory(study.folder())) {
      return List.of();
    }
    try (Stream<Path> found = Files.list(study.folder())) {
      return found
          .filter(path -> path.getFileName().toString().startsWith("sub-"))
          .filter(path -> Files.isRegularFile(TrialLog.of(path)))
          .sorted()
          .toList();
    }
  }

  private static boolean attends(
      ThresholdStudy study, Path folder, List<JsonNode> events, ProblemCollector problems) {
    List<JsonNode> catches =
        events.stream().filter(event -> is(event, "trial") && event.has("catch")).toList();
    long right = catches.stream().filter(event -> event.path("correct").asBoolean()).count();
    if (right < study.attention() * catches.size()) {
      problems.warning(
          SourceLocation.of(TrialLog.of(folder).toString()),
          ("%s is left out: of %d catch trials %d were answered right, but \"attention\" requires"
                  + " a share of %s")
              .formatted(folder.getFileName(), catches.size(), right, study.attention()));
      return false;
    }
    if (events.stream().noneMatch(event -> is(event, "pilot-finished"))) {
      problems.warning(
          SourceLocation.of(TrialLog.of(folder).toString()),
          "the trials of %s are not finished; objects with a threshold count; --resume continues"
              .formatted(folder.getFileName()));
    }
    return true;
  }

  private static boolean is(JsonNode event, String name) {
    return event.path("event").asText().equals(name);
  }

  private static ObjectThreshold of(String object, List<JsonNode> events) {
    int original = 0;
    List<ThresholdEstimate> estimates = new ArrayList<>();
    for (JsonNode event : events) {
      if (is(event, "threshold") && event.path("object").asText().equals(object)) {
        original = event.path("original").asInt();
        estimates.add(
            new ThresholdEstimate(
                kind(event.path("outcome").asText()), event.path("polygons").asDouble()));
      }
    }
    return new ObjectThreshold(object, original, estimates);
  }

  private static Kind kind(String spelling) {
    return Stream.of(Kind.values())
        .filter(kind -> kind.spelling().equals(spelling))
        .findFirst()
        .orElse(Kind.OPEN);
  }

  /**
   * Returns the shell commands that make the recommended versions, a line each; a comment for an
   * object without a recommendation.
   *
   * @param program the program's name on the command line
   * @param scene the scene's path in the commands
   */
  public String commands(String program, String scene) {
    StringBuilder text = new StringBuilder();
    for (ObjectThreshold object : objects) {
      text.append(
          object
              .wanted()
              .map(
                  polygons ->
                      String.format(
                          Locale.ROOT,
                          "%s versions %s --object%s%s --polygons %d\n",
                          program,
                          quoted(scene.startsWith("-") ? "./" + scene : scene),
                          object.object().startsWith("-") ? "=" : " ",
                          quoted(object.object()),
                          polygons))
              .orElseGet(
                  () ->
                      "# "
                          + ControlCharacterEscaper.line(object.object())
                          + (object.estimates().isEmpty()
                              ? ": nobody's threshold is known yet\n"
                              : ": no reduced version was good enough for most; leave it as it is\n")));
    }
    return text.toString();
  }

  private static String quoted(String word) {
    return word.matches("[\\w./:@%+=,-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}
