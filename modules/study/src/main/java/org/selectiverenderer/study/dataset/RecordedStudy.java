package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
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
   * Returns the table of participants; with a column of the ids of a recruiting service, where
   * there are any. These lead to persons: they are for those who pay them, and in no dataset.
   */
  public DataTable participantsTable() {
    Map<String, String> recruited = new HashMap<>();
    for (RecordedSession session : sessions) {
      String ids =
          session.recruitment().entrySet().stream()
              .map(id -> id.getKey() + "=" + id.getValue())
              .collect(Collectors.joining("|"));
      if (!ids.isEmpty()) {
        recruited.putIfAbsent(session.folder().participant(), ids);
      }
    }
    return participants.table(material.form(), recruited);
  }

  /**
   * Reads the data from the study's folder.
   *
   * @param problems receives a warning for each damaged part, which is left out
   * @throws IOException if a file cannot be read
   */
  public static RecordedStudy read(LoadedStudy material, ProblemCollector problems)
      throws IOException {
    return read(material, session -> true, problems);
  }

  /**
   * As {@link #read(LoadedStudy, ProblemCollector)}.
   *
   * @param used which sessions are read; participants all of whose sessions are passed over are not
   *     in the table of participants either
   */
  public static RecordedStudy read(
      LoadedStudy material, Predicate<SessionFolder> used, ProblemCollector problems)
      throws IOException {
    Set<String> passed = new HashSet<>();
    List<RecordedSession> sessions = new ArrayList<>();
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      if (used.test(folder)) {
        RecordedSession.read(folder, problems).ifPresent(sessions::add);
      } else {
        passed.add(folder.participant());
      }
    }
    sessions.forEach(session -> passed.remove(session.folder().participant()));
    ParticipantsTable people =
        ParticipantsTable.read(material.study().folder().resolve("participants.tsv"), problems);
    return new RecordedStudy(material, people.without(passed), sessions);
  }
}
