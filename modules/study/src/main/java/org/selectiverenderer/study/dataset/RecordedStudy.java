package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;

/**
 * A study with all its recorded data.
 *
 * @param sessions in order of participants, then of session numbers
 */
public record RecordedStudy(
    LoadedStudy material, ParticipantsTable participants, List<RecordedSession> sessions) {
  public RecordedStudy {
    sessions = List.copyOf(sessions);
  }

  public Study study() {
    return material.study();
  }

  /**
   * Reads the data from the study's folder.
   *
   * @param problems receives a warning for each damaged part, which is left out
   * @throws IOException if a file cannot be read
   */
  public static RecordedStudy read(LoadedStudy material, ProblemCollector problems)
      throws IOException {
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
