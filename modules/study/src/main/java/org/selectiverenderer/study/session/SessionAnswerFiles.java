package org.selectiverenderer.study.session;

import java.util.LinkedHashMap;
import java.util.Map;
import org.selectiverenderer.study.questionnaire.AnswerTableKind;
import org.selectiverenderer.study.questionnaire.AnswersCsvBuilder;
import org.selectiverenderer.study.questionnaire.Respondent;

/** Builds the tables of answers that a finished session leaves in its folder. */
public final class SessionAnswerFiles {
  private SessionAnswerFiles() {}

  /** Returns the texts of the tables that have rows, by the names of their files. */
  public static Map<String, String> of(
      LoadedStudy material, SessionFolder folder, SessionHistory history) {
    Map<String, String> files = new LinkedHashMap<>();
    AnswersCsvBuilder tables = new AnswersCsvBuilder();
    for (SessionStep step : material.steps()) {
      if (LoadedStudy.asks(step)) {
        tables.add(
            new Respondent(
                folder.participant(),
                Integer.toString(folder.number()),
                history.group().orElse(""),
                step.id()),
            material.questionnaire(step, folder.participant()),
            history.given(step));
      }
    }
    for (AnswerTableKind table : AnswerTableKind.values()) {
      if (tables.has(table)) {
        files.put(table.file(), tables.text(table));
      }
    }
    TrialsTable trials = new TrialsTable(material, true);
    trials.add(folder.participant(), folder.number(), history);
    if (!trials.isEmpty()) {
      files.put("trials.csv", trials.text());
    }
    if (tables.hasScores()) {
      files.put("scores.csv", tables.scores());
    }
    return files;
  }
}
