package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.Comparator;
import java.util.Optional;
import org.selectiverenderer.study.definition.Study;

/** The language in which a participant has had sessions of a study. */
public final class ParticipantLanguage {
  private ParticipantLanguage() {}

  /**
   * Returns the language of a session that has begun, else that of the participant's last session
   * before it.
   *
   * @param number of the session
   * @return empty if no journal tells a language
   * @throws IOException if a journal cannot be read
   */
  public static Optional<String> of(Study study, String participant, int number)
      throws IOException {
    for (SessionFolder folder :
        SessionFolder.all(study).stream()
            .filter(one -> one.participant().equals(participant) && one.number() <= number)
            .sorted(Comparator.comparingInt(SessionFolder::number).reversed())
            .toList()) {
      Optional<String> language = SessionHistory.read(folder.journal()).language();
      if (language.isPresent()) {
        return language;
      }
    }
    return Optional.empty();
  }
}
