package org.selectiverenderer.experiment.dataset;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.AnswerTable;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;

/**
 * The answers of a session, from its journal: each question's last one, screen by screen. Left out
 * are personal ones, whether the study said so then or says so now, and those that come into no
 * other table either: to examples, and to what was no longer asked after another answer.
 */
public final class SessionAnswers {
  private static final Map<String, String> YES = yes();

  private final RecordedStudy study;
  private final Optional<CsvTable> truths;

  private SessionAnswers(RecordedStudy study, Optional<CsvTable> truths) {
    this.study = study;
    this.truths = truths;
  }

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

  /** The rows of each screen that has some, by its step's id, in order. */
  public static Map<String, List<List<@Nullable Object>>> rows(
      RecordedStudy study, RecordedSession session, Problems problems) throws IOException {
    Map<String, Map<String, JournalLine>> last = new LinkedHashMap<>();
    for (JournalLine line : session.events()) {
      if (line.event().equals("answer")) {
        last.computeIfAbsent(line.step(), step -> new LinkedHashMap<>())
            .put(line.text("object"), line);
      }
    }
    SessionAnswers answers =
        new SessionAnswers(
            study, truths(session.folder().path().resolve("responses.csv"), problems));
    Map<String, List<List<@Nullable Object>>> rows = new LinkedHashMap<>();
    last.forEach(
        (step, given) -> {
          List<List<@Nullable Object>> own = answers.rows(step, given);
          if (!own.isEmpty()) {
            rows.put(step, own);
          }
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

  private List<List<@Nullable Object>> rows(String step, Map<String, JournalLine> given) {
    Optional<Questionnaire> asked = Optional.ofNullable(study.questionnaires().get(step));
    Map<String, Answer> answers = new HashMap<>();
    given.forEach(
        (id, line) ->
            answers.put(
                id,
                new Answer(
                    value(line.members().path("value")),
                    line.members().path("confidence").asInt())));
    Set<String> counting =
        asked.map(known -> known.counting(answers).keySet()).orElse(answers.keySet());
    List<List<@Nullable Object>> rows = new ArrayList<>();
    given.forEach(
        (id, line) -> {
          Optional<Question> question = asked.flatMap(known -> known.question(id));
          boolean kept =
              question
                  .map(known -> known.inTables() && counting.contains(id))
                  .orElse(true); // The study has changed: as it was asked then.
          if (kept && !line.members().path(JournalLine.PERSONAL).asBoolean()) {
            rows.add(row(line, asked, question));
          }
        });
    return rows;
  }

  private List<@Nullable Object> row(
      JournalLine line, Optional<Questionnaire> asked, Optional<Question> question) {
    JsonNode members = line.members();
    List<@Nullable Object> row = new ArrayList<>();
    row.add(line.text("object"));
    row.add(value(members.path("value")));
    row.add(members.path("confidence").asInt() > 0 ? members.path("confidence").asInt() : null);
    row.add(members.has("ms") ? members.path("ms").asDouble() / 1000 : null);
    row.add(members.has("place") ? members.path("place").asInt() : null);
    String area = asked.map(Questionnaire::area).orElseGet(() -> area(line.step()));
    row.add(area);
    Optional<CsvRow> truth =
        question
                .map(known -> known.kind().table() == AnswerTable.RESPONSES)
                .orElseGet(() -> line.step().startsWith("recognition-"))
            ? truth(area, line.text("object"))
            : Optional.empty();
    row.add(truth.map(known -> known.cell("consistency")).orElse(null));
    row.add(truth.map(known -> known.cell("present")).orElse(null));
    return row;
  }

  /** Of a questionnaire that the study no longer has. */
  private static String area(String step) {
    return step.startsWith("recognition-") || step.startsWith("expectancy-")
        ? step.substring(step.indexOf('-') + 1)
        : "";
  }

  private Optional<CsvRow> truth(String area, String object) {
    return truths.stream()
        .flatMap(table -> table.rows().stream())
        .filter(row -> row.cell("area").equals(area) && row.cell("object").equals(object))
        .findFirst();
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
