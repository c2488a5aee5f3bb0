package org.selectiverenderer.experiment.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.Study;

/**
 * All that was recorded of a study.
 *
 * @param sessions by participant, then by number
 */
public record RecordedStudy(
    StudyMaterial material, ParticipantsTable participants, List<RecordedSession> sessions) {
  public RecordedStudy {
    sessions = List.copyOf(sessions);
  }

  public Study study() {
    return material.study();
  }

  /**
   * Reads it from the study's folder.
   *
   * @param problems hears of what is damaged, and is left out
   * @throws IOException if a file cannot be read at all
   */
  public static RecordedStudy read(StudyMaterial material, Problems problems) throws IOException {
    List<RecordedSession> sessions = new ArrayList<>();
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      RecordedSession.read(folder, problems).ifPresent(sessions::add);
    }
    return new RecordedStudy(
        material,
        ParticipantsTable.read(material.study().folder().resolve("participants.tsv"), problems),
        sessions);
  }
}
