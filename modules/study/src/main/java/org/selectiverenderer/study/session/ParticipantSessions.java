package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/** All sessions of one participant, with the choice of the one that counts. */
final class ParticipantSessions {
  private final LoadedStudy material;
  private final String participant;
  private final Map<SessionFolder, SessionHistory> sessions = new LinkedHashMap<>();

  private ParticipantSessions(LoadedStudy material, String participant) {
    this.material = material;
    this.participant = participant;
  }

  /**
   * Returns the sessions of all participants who have a folder or a condition, in order.
   *
   * @param used which sessions are there; the others are passed over
   */
  static List<ParticipantSessions> all(LoadedStudy material, Predicate<SessionFolder> used)
      throws IOException {
    Map<String, ParticipantSessions> all = new LinkedHashMap<>();
    Set<String> passed = new HashSet<>();
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      if (!used.test(folder)) {
        passed.add(folder.participant());
        continue;
      }
      all.computeIfAbsent(folder.participant(), id -> new ParticipantSessions(material, id))
          .sessions
          .put(folder, SessionHistory.read(folder.journal()));
    }
    for (ParticipantsFile.Assigned assigned : new ParticipantsFile(material.study()).all()) {
      if (!passed.contains(assigned.participant())) {
        all.computeIfAbsent(assigned.participant(), id -> new ParticipantSessions(material, id));
      }
    }
    return new ArrayList<>(all.values());
  }

  String participant() {
    return participant;
  }

  SessionHistory history(SessionFolder folder) {
    return sessions.get(folder);
  }

  /** Returns the session that counts; empty if there is none. */
  Optional<SessionFolder> chosen(OptionalInt number) {
    if (number.isPresent()) {
      return sessions.keySet().stream()
          .filter(folder -> folder.number() == number.getAsInt())
          .findFirst();
    }
    // An excluded session is chosen only if there is no other, so that it is reported.
    return Stream.<Predicate<SessionFolder>>of(
            folder -> answered(folder) && excluding(folder).isEmpty(),
            folder -> begun(folder) && excluding(folder).isEmpty(),
            this::begun,
            folder -> true)
        .flatMap(wanted -> sessions.keySet().stream().filter(wanted))
        .findFirst();
  }

  /** Returns the flags by which the study excludes a session. */
  List<SessionFlagEvent> excluding(SessionFolder folder) {
    return history(folder).excluding(material.study().quality());
  }

  /** Reports the damaged lines of the sessions' journals. */
  void tellDamage(ProblemCollector problems) {
    sessions.forEach((folder, history) -> history.tellDamage(folder.journal(), problems));
  }

  private boolean answered(SessionFolder folder) {
    return material.steps().stream()
        .filter(step -> step instanceof SessionStep.Questions || step instanceof SessionStep.Block)
        .allMatch(history(folder)::finished);
  }

  private boolean begun(SessionFolder folder) {
    return !history(folder).answeredSteps().isEmpty() || !history(folder).results().isEmpty();
  }

  /** Reports the answers that are left out because their session does not count. */
  void tellOthers(Optional<SessionFolder> chosen, OptionalInt number, ProblemCollector problems) {
    if (chosen.isEmpty()) {
      problems.warning(
          SourceLocation.of(material.study().folder().resolve("participants.tsv").toString()),
          "the participant %s has no session%s; no answers of theirs are in the tables"
              .formatted(participant, number.isPresent() ? " " + number.getAsInt() : ""));
    }
    sessions.forEach(
        (folder, history) -> {
          int answers = history.answerCount();
          if (chosen.isPresent() && folder.equals(chosen.get()) || answers == 0) {
            return;
          }
          problems.warning(
              SourceLocation.of(folder.journal().toString()),
              ("%s of session %d of the participant %s left out, because %s; "
                      + "--session %d uses them")
                  .formatted(
                      answers == 1 ? "1 answer" : answers + " answers",
                      folder.number(),
                      participant + (answers == 1 ? " is" : " are"),
                      chosen
                          .map(counts -> "session " + counts.number() + " counts")
                          .orElse("--session asks for another"),
                      folder.number()));
        });
  }
}
