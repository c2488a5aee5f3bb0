package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.statistics.data.ResponsesCsv;

/** A table of answers, one file of a session and of a study. */
public enum AnswerTable {
  /** Answers about memory, as {@code experiment analyse} reads them. */
  RESPONSES("responses.csv", ResponsesCsv.of(List.of()).strip() + ",response_ms,place\n"),
  /** Ratings of expectancy, as {@code enrich --ratings} reads them. */
  RATINGS("ratings.csv", "participant,area,object,schema,rating,response_ms,place\n"),
  /** All others, a row for each question that was asked. */
  ANSWERS(
      "answers.csv",
      CsvText.line(
          "participant",
          "session",
          "condition",
          "questionnaire",
          "page",
          "question",
          "kind",
          "value",
          "response_ms",
          "place"));

  private final String file;
  private final String header;

  AnswerTable(String file, String header) {
    this.file = file;
    this.header = header;
  }

  /** Its name in a session's folder. */
  public String file() {
    return file;
  }

  /** Its first line, ended. */
  public String header() {
    return header;
  }
}
