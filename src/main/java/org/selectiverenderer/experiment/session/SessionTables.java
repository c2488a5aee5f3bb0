package org.selectiverenderer.experiment.session;

import java.io.IOException;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.AnswerTable;
import org.selectiverenderer.experiment.questionnaire.AnswersCsv;
import org.selectiverenderer.experiment.questionnaire.AskedBy;

/** Writes the tables of a session's answers into its folder. */
record SessionTables(StudyMaterial material, SessionFolder folder) {
  /** Writes the tables that have rows. */
  void write(SessionHistory history) throws IOException {
    AnswersCsv tables = new AnswersCsv();
    for (SessionStep step : material.steps()) {
      if (StudyMaterial.asks(step)) {
        tables.add(
            by(step, history),
            material.questionnaire(step, folder.participant()),
            history.given(step));
      }
    }
    for (AnswerTable table : AnswerTable.values()) {
      if (tables.has(table)) {
        folder.writeOnce(table.file(), tables.text(table));
      }
    }
    if (tables.hasScores()) {
      folder.writeOnce("scores.csv", tables.scores());
    }
  }

  private AskedBy by(SessionStep step, SessionHistory history) {
    return new AskedBy(
        folder.participant(),
        Integer.toString(folder.number()),
        history.condition().map(Condition::spelling).orElse(""),
        step.id());
  }
}
