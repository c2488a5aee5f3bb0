package org.selectiverenderer.study.export;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedRun;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.SessionsTable;

/**
 * A study written as tidy tables (Wickham 2014).
 *
 * @param files names of the written files, in order
 */
public record StudyExport(List<String> files) {
  /** The table of recognition answers, as {@code experiment analyse} reads it. */
  public static final String RESPONSES = "responses.csv";

  private static final List<String> SCRIPTS = List.of("tables.R", "tables.py");

  public StudyExport {
    files = List.copyOf(files);
  }

  /**
   * The collected answers, as CSV texts of {@code experiment collect}.
   *
   * @param responses answers to recognition lists
   * @param ratings ratings of expectancy
   * @param others answers to questions of other kinds
   * @param scores scores computed from the answers
   */
  public record Answers(String responses, String ratings, String others, String scores) {}

  /**
   * Writes all files, or none; files of an earlier export are replaced.
   *
   * @param more further files by their names, such as scripts
   * @param problems receives a warning for each damaged part, which is left out
   * @throws IOException if a file cannot be read or written
   */
  public static StudyExport write(
      RecordedStudy study,
      Answers answers,
      Map<String, String> more,
      Path folder,
      ProblemCollector problems)
      throws IOException {
    List<DataTable> tables = tables(study, answers, problems);
    Map<String, String> files = new LinkedHashMap<>();
    tables.forEach(table -> files.put(table.name() + ".csv", table.csv()));
    files.put("codebook.csv", Codebook.csv(tables));
    files.put("codebook.json", Codebook.json(tables));
    for (String script : SCRIPTS) {
      files.put(script, resource(script));
    }
    files.putAll(more);
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    files.forEach(
        (name, text) -> writing.add(folder.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
    writing.commit();
    return new StudyExport(List.copyOf(files.keySet()));
  }

  private static List<DataTable> tables(
      RecordedStudy study, Answers answers, ProblemCollector problems) throws IOException {
    DataTable sessions =
        new DataTable("sessions", "a session of a participant", SessionsTable.columns());
    RunTables runs = new RunTables(study.study().fade(), problems);
    for (RecordedSession session : study.sessions()) {
      sessions.add(SessionsTable.row(session, study.study().fade()));
      for (RecordedRun run : session.runs()) {
        runs.add(run);
      }
    }
    AnswerTableParser asked = new AnswerTableParser(problems);
    List<DataTable> tables = new ArrayList<>();
    tables.add(study.participants().table(study.material().form()));
    tables.add(sessions);
    tables.addAll(runs.tables());
    tables.add(
        asked.table(
            "responses", "an object that a participant was asked about", answers.responses()));
    tables.add(
        asked.table(
            "ratings", "how likely a participant finds an object in an area", answers.ratings()));
    tables.add(
        asked.table("answers", "the answer to a question of another kind", answers.others()));
    tables.add(asked.table("scores", "a score of a questionnaire", answers.scores()));
    return tables;
  }

  private static String resource(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StudyExport.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
