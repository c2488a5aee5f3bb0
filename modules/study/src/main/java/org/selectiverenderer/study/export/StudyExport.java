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
import org.selectiverenderer.study.session.CollectedAnswers;

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
   * @param trials finished trials of blocks; without rows there is no table of trials
   */
  public record Answers(
      String responses, String ratings, String others, String scores, String trials) {
    /** Makes the answers of a study without trials. */
    public Answers(String responses, String ratings, String others, String scores) {
      this(responses, ratings, others, scores, "");
    }

    /** Returns collected answers as they are in the tables. */
    public static Answers of(CollectedAnswers all) {
      return new Answers(all.responses(), all.ratings(), all.others(), all.scores(), all.trials());
    }
  }

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
    return write(tables(study, answers, problems), more, folder);
  }

  /** As {@link #write(RecordedStudy, Answers, Map, Path, ProblemCollector)}, of given tables. */
  public static StudyExport write(List<DataTable> tables, Map<String, String> more, Path folder)
      throws IOException {
    Map<String, String> files = files(tables);
    files.putAll(more);
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    files.forEach(
        (name, text) -> writing.add(folder.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
    writing.commit();
    return new StudyExport(List.copyOf(files.keySet()));
  }

  /** Returns the texts of tables, of their codebook and of the scripts that read them, by name. */
  public static Map<String, String> files(List<DataTable> tables) throws IOException {
    Map<String, String> files = new LinkedHashMap<>();
    tables.forEach(table -> files.put(table.name() + ".csv", table.csv()));
    files.put("codebook.csv", Codebook.csv(tables));
    files.put("codebook.json", Codebook.json(tables));
    for (String script : SCRIPTS) {
      files.put(script, resource(script));
    }
    return files;
  }

  /**
   * Returns all tables of a study.
   *
   * @param problems receives a warning for each damaged part, which is left out
   * @throws IOException if a file cannot be read
   */
  public static List<DataTable> tables(
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
    tables.add(study.participantsTable());
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
    if (answers.trials().lines().count() > 1) {
      tables.add(asked.table("trials", "a finished trial of a block", answers.trials()));
    }
    return tables;
  }

  private static String resource(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StudyExport.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
