package org.selectiverenderer.experiment.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.Study;

/**
 * All that was recorded of a study.
 *
 * @param questionnaires what the study asks now, the form too, by the ids of the steps
 * @param sessions by participant, then by number
 */
public record RecordedStudy(
    Study study,
    Map<String, Questionnaire> questionnaires,
    ParticipantsTable participants,
    List<RecordedSession> sessions) {
  public RecordedStudy {
    questionnaires = Map.copyOf(questionnaires);
    sessions = List.copyOf(sessions);
  }

  /**
   * Reads it from the study's folder.
   *
   * @param problems hears of what is damaged, and is left out
   * @throws IOException if a file cannot be read at all
   */
  public static RecordedStudy read(StudyMaterial material, Problems problems) throws IOException {
    Study study = material.study();
    List<RecordedSession> sessions = new ArrayList<>();
    for (SessionFolder folder : SessionFolder.all(study)) {
      RecordedSession.read(folder, problems).ifPresent(sessions::add);
    }
    Map<String, Questionnaire> questionnaires = new HashMap<>();
    questionnaires.put(material.form().id(), material.form());
    material.asked().stream()
        .map(StudyMaterial.Asked::questionnaire)
        .forEach(each -> questionnaires.put(each.id(), each));
    return new RecordedStudy(
        study,
        questionnaires,
        ParticipantsTable.read(study.folder().resolve("participants.tsv"), problems),
        sessions);
  }

  /** Whether the study says now that the answer to a question stays in the session's journal. */
  public boolean personal(String step, String question) {
    return Optional.ofNullable(questionnaires.get(step))
        .flatMap(asked -> asked.question(question))
        .map(Question::personal)
        .orElse(false);
  }
}
