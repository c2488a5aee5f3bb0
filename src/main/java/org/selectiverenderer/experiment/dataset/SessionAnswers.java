package org.selectiverenderer.experiment.dataset;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.base.problem.Problems;

/** The answers of a session, from its journal: each question's last one, screen by screen. */
public final class SessionAnswers {
  private static final Map<String, String> YES = yes();

  private SessionAnswers() {}

  /** The columns of {@link #rows}. */
  public static List<TableColumn> columns() {
    return List.of(
        TableColumn.text(
            "question", "the question's id; for recognition and expectancy the object"),
        TableColumn.text("response", "what was answered; several choices are joined by |"),
        TableColumn.whole(
            "confidence", "how sure the participant was, 1 (not at all) to 5 (certain)"),
        TableColumn.number(
            "response_time", "s", "from when the question was shown until this answer"),
        TableColumn.whole("place", "the question's number on its screen, from 1"),
        TableColumn.text("area", "of the scene that the question is about"),
        TableColumn.text("consistency", "of the object with the area's schema"),
        TableColumn.category("present", YES, "whether the object was in the scene"));
  }

  private static Map<String, String> yes() {
    Map<String, String> levels = new LinkedHashMap<>();
    levels.put("yes", "it was there");
    levels.put("no", "it was not");
    return levels;
  }

  /** The rows of each screen that was begun, by its step's id, in order. */
  public static Map<String, List<List<@Nullable Object>>> rows(
      RecordedSession session, Problems problems) throws IOException {
    Map<String, Map<String, JournalLine>> last = new LinkedHashMap<>();
    for (JournalLine line : session.events()) {
      if (line.event().equals("answer")) {
        last.computeIfAbsent(line.step(), step -> new LinkedHashMap<>())
            .put(line.text("object"), line);
      }
    }
    Optional<CsvTable> truths = truths(session.folder().path().resolve("responses.csv"), problems);
    Map<String, List<List<@Nullable Object>>> rows = new LinkedHashMap<>();
    last.forEach(
        (step, answers) -> {
          List<List<@Nullable Object>> own = new ArrayList<>();
          answers.values().forEach(line -> own.add(row(line, truths)));
          rows.put(step, own);
        });
    return rows;
  }

  private static Optional<CsvTable> truths(Path responses, Problems problems) throws IOException {
    List<String> needed = List.of("area", "object", "consistency", "present");
    return Files.isRegularFile(responses)
        ? CsvTable.read(responses, CsvColumns.of(needed), problems::warning)
            .filter(table -> table.require(needed, String.join(",", needed)))
        : Optional.empty();
  }

  private static List<@Nullable Object> row(JournalLine line, Optional<CsvTable> truths) {
    JsonNode members = line.members();
    List<@Nullable Object> row = new ArrayList<>();
    row.add(line.text("object"));
    row.add(value(members.path("value")));
    row.add(members.path("confidence").asInt() > 0 ? members.path("confidence").asInt() : null);
    row.add(members.has("ms") ? members.path("ms").asDouble() / 1000 : null);
    row.add(members.has("place") ? members.path("place").asInt() : null);
    String area =
        line.step().startsWith("recognition-") || line.step().startsWith("expectancy-")
            ? line.step().substring(line.step().indexOf('-') + 1)
            : "";
    row.add(area);
    truths
        .flatMap(
            table ->
                table.rows().stream()
                    .filter(truth -> truth.cell("area").equals(area))
                    .filter(truth -> truth.cell("object").equals(line.text("object")))
                    .filter(truth -> line.step().startsWith("recognition-"))
                    .findFirst())
        .ifPresentOrElse(
            truth -> {
              row.add(truth.cell("consistency"));
              row.add(truth.cell("present"));
            },
            () -> {
              row.add(null);
              row.add(null);
            });
    return row;
  }

  private static String value(JsonNode value) {
    if (!value.isArray()) {
      return value.asText();
    }
    List<String> chosen = new ArrayList<>();
    value.forEach(choice -> chosen.add(choice.asText()));
    return String.join("|", chosen);
  }
}
