package org.selectiverenderer.experiment.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.study.Study;

/**
 * All that was recorded of a study.
 *
 * @param sessions by participant, then by number
 */
public record RecordedStudy(
    Study study, ParticipantsTable participants, List<RecordedSession> sessions) {
  public RecordedStudy {
    sessions = List.copyOf(sessions);
  }

  /**
   * Reads it from the study's folder.
   *
   * @param problems hears of what is damaged, and is left out
   * @throws IOException if a file cannot be read at all
   */
  public static RecordedStudy read(Study study, Problems problems) throws IOException {
    List<RecordedSession> sessions = new ArrayList<>();
    for (SessionFolder folder : SessionFolder.all(study)) {
      RecordedSession.read(folder, problems).ifPresent(sessions::add);
    }
    return new RecordedStudy(
        study,
        ParticipantsTable.read(study.folder().resolve("participants.tsv"), problems),
        sessions);
  }
}
