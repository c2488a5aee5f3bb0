package org.selectiverenderer.study.questionnaire;

import java.util.List;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;

/** The tables of answers: each is a file of a session, and of the collected study. */
public enum AnswerTableKind {
  /** Answers to recognition lists, in the form that {@code experiment analyse} reads. */
  RESPONSES("responses.csv", ResponsesCsvWriter.of(List.of()).strip() + ",response_ms,place\n"),
  /** Ratings of expectancy, in the form that {@code enrich --ratings} reads. */
  RATINGS("ratings.csv", "participant,area,object,schema,rating,response_ms,place\n"),
  /** All other answers, with a row for each question that was asked. */
  ANSWERS(
      "answers.csv",
      CsvWriter.line(
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

  AnswerTableKind(String file, String header) {
    this.file = file;
    this.header = header;
  }

  /** Returns the file's name in a session's folder. */
  public String file() {
    return file;
  }

  /** Returns the header line, ended. */
  public String header() {
    return header;
  }
}
