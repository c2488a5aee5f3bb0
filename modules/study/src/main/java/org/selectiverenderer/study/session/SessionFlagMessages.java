package org.selectiverenderer.study.session;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.definition.SessionFlag;

/** Reports what the quality flags of a session mean for its answers. */
final class SessionFlagMessages {
  private SessionFlagMessages() {}

  /** Reports the flags of a session whose answers are collected. */
  static void tell(SessionHistory history, SourceLocation place, ProblemCollector problems) {
    byFlag(history.flags())
        .forEach(
            (flag, steps) ->
                problems.info(
                    place,
                    switch (flag) {
                      case SIMULATED ->
                          "the participant of this session was simulated; the answers are kept";
                      case SHORTENED ->
                          "exposures of this session were shortened; the answers are kept";
                      default ->
                          "the session is flagged %s; the answers are kept, as the study does not exclude it"
                              .formatted(named(flag, steps));
                    }));
  }

  /** Reports that the study excludes a session, with the participant's answers on paper. */
  static void tellExcluded(
      ParticipantSessions sessions,
      SessionFolder folder,
      PaperAnswers paper,
      ProblemCollector problems) {
    int answers =
        sessions.history(folder).answerCount()
            + paper.sheets(folder.participant()).values().stream()
                .mapToInt(sheet -> sheet.answers().size())
                .sum();
    String why =
        byFlag(sessions.excluding(folder)).entrySet().stream()
            .map(flag -> named(flag.getKey(), flag.getValue()))
            .collect(Collectors.joining(", "));
    problems.warning(
        SourceLocation.of(folder.journal().toString()),
        "%s of session %d of the participant %s left out, because the study excludes sessions flagged %s"
            .formatted(
                answers == 1 ? "1 answer" : answers + " answers",
                folder.number(),
                folder.participant() + (answers == 1 ? " is" : " are"),
                why));
  }

  private static Map<SessionFlag, List<String>> byFlag(List<SessionFlagEvent> flags) {
    return flags.stream()
        .collect(
            Collectors.groupingBy(
                SessionFlagEvent::flag,
                TreeMap::new,
                Collectors.mapping(SessionFlagEvent::step, Collectors.toList())));
  }

  private static String named(SessionFlag flag, List<String> steps) {
    List<String> known = steps.stream().filter(step -> !step.isEmpty()).distinct().toList();
    return flag.spelling() + (known.isEmpty() ? "" : " (" + String.join(", ", known) + ")");
  }
}
