package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.AnswersCsv;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.questionnaire.Screen;
import org.selectiverenderer.schema.Band;

/**
 * The answers of a study, one session of each participant, from their journals, and those given on
 * paper. Screens that were finished count, of sessions that were not, too; every answer that does
 * not count, and every session that is not what it seems, is a problem with its file's name.
 *
 * @param responses as {@code experiment analyse} reads them
 * @param ratings as {@code enrich --ratings} reads them
 * @param bands means of the ratings with their bands, for people
 * @param participants of whom there are answers
 * @param answers that are in the tables
 */
public record CollectedAnswers(
    String responses, String ratings, String bands, int participants, int answers) {

  private record Rated(String area, String schema, String object) {}

  /** Gathers what the record holds. */
  private static final class Gathering {
    private final StudyMaterial material;
    private final PaperAnswers paper;
    private final Problems problems;
    private final StringBuilder responses = new StringBuilder(AnswersCsv.responsesHeader());
    private final StringBuilder ratings = new StringBuilder(AnswersCsv.RATINGS);
    private final Map<Rated, List<Integer>> all = new LinkedHashMap<>();
    private int participants;
    private int answers;

    Gathering(StudyMaterial material, PaperAnswers paper, Problems problems) {
      this.material = material;
      this.paper = paper;
      this.problems = problems;
    }

    /** A participant with a session. */
    void session(SessionFolder folder, SessionHistory history) {
      Location place = Location.of(folder.journal().toString());
      if (history.refused()) {
        problems.info(place, "the participant does not take part");
        paper
            .sheets(folder.participant())
            .values()
            .forEach(
                sheet ->
                    problems.error(
                        sheet.place(),
                        ("participant %s does not take part; the answers from paper "
                                + "are left out")
                            .formatted(folder.participant())));
        return;
      }
      if (history.unattended()) {
        problems.info(place, "the participant of this session was simulated; the answers are kept");
      } else if (history.shortened()) {
        problems.info(place, "exposures of this session were shortened; the answers are kept");
      }
      int before = answers;
      List<String> known = new ArrayList<>();
      for (SessionStep step : material.steps()) {
        known.add(step.id());
        if (step instanceof SessionStep.Questions questions) {
          screen(folder, history, questions, place);
        }
      }
      for (String step : history.answeredSteps()) {
        if (!known.contains(step)) {
          problems.warning(
              place, "the study no longer has " + step + "; the answers to it are left out");
        }
      }
      unasked(folder.participant());
      participants += answers > before ? 1 : 0;
    }

    /** A participant who has answered on paper and has no session. */
    void onPaper(String participant) {
      int before = answers;
      for (SessionStep step : material.steps()) {
        if (step instanceof SessionStep.Questions questions) {
          paper
              .sheet(participant, step.id())
              .ifPresent(sheet -> sheet(questions, participant, sheet));
        }
      }
      unasked(participant);
      participants += answers > before ? 1 : 0;
    }

    private void unasked(String participant) {
      List<String> steps = material.steps().stream().map(SessionStep::id).toList();
      paper
          .sheets(participant)
          .forEach(
              (step, sheet) -> {
                if (!steps.contains(step)) {
                  problems.error(
                      sheet.place(),
                      ("the study has no screen %s; the answers of participant %s to "
                              + "it are left out")
                          .formatted(step, participant));
                }
              });
    }

    private void screen(
        SessionFolder folder, SessionHistory history, SessionStep.Questions step, Location place) {
      Map<String, Answer> given = history.answers(step);
      Optional<PaperAnswers.Sheet> sheet = paper.sheet(folder.participant(), step.id());
      if (history.finished(step)) {
        sheet.ifPresent(
            typed ->
                problems.error(
                    typed.place(),
                    ("participant %s has answered %s in the program; the answers from "
                            + "paper are left out")
                        .formatted(folder.participant(), step.id())));
        String condition = history.condition().map(Condition::spelling).orElse("");
        take(step, folder.participant(), condition, given, place);
        return;
      }
      if (sheet.isEmpty() || !given.isEmpty()) {
        problems.warning(
            place,
            "the questions of %s were not finished; %s left out"
                .formatted(
                    step.id(),
                    given.size() == 1 ? "the 1 answer is" : given.size() + " answers are"));
      }
      sheet.ifPresent(typed -> sheet(step, folder.participant(), typed));
    }

    private void sheet(SessionStep.Questions step, String participant, PaperAnswers.Sheet sheet) {
      String condition = paper.condition(participant).map(Condition::spelling).orElse("");
      take(step, participant, condition, sheet.answers(), sheet.place());
    }

    /** Takes the answers to a screen into the tables. */
    private void take(
        SessionStep.Questions step,
        String participant,
        String condition,
        Map<String, Answer> given,
        Location place) {
      Screen screen = material.screen(step, participant);
      (screen.withConfidence() ? responses : ratings)
          .append(AnswersCsv.lines(screen, participant, condition, given));
      Map<String, Answer> left = new LinkedHashMap<>(given);
      for (QuestionItem item : screen.items()) {
        Optional<Answer> answer =
            Optional.ofNullable(left.remove(item.object())).filter(counts -> !item.example());
        answers += answer.isPresent() ? 1 : 0;
        if (!screen.withConfidence()) {
          answer.ifPresent(
              rating ->
                  all.computeIfAbsent(
                          new Rated(item.area(), item.schema(), item.object()),
                          key -> new ArrayList<>())
                      .add(Integer.parseInt(rating.value())));
        }
      }
      if (!left.isEmpty()) {
        problems.warning(
            place,
            "the study no longer asks about %s in %s; these answers are left out"
                .formatted(String.join(", ", left.keySet().stream().sorted().toList()), step.id()));
      }
    }
  }

  /**
   * Collects them.
   *
   * @param session the number of the session that counts; empty for each participant's first whose
   *     questions are all answered, or the first with answers where there is none
   * @param paper answers typed in; they stand for screens that a session has not finished
   * @throws IOException if a journal cannot be read
   */
  public static CollectedAnswers of(
      StudyMaterial material, OptionalInt session, PaperAnswers paper, Problems problems)
      throws IOException {
    Gathering gathering = new Gathering(material, paper, problems);
    Set<String> onPaper = paper.participants();
    for (ParticipantSessions sessions : ParticipantSessions.all(material)) {
      Optional<SessionFolder> chosen = sessions.chosen(session);
      if (chosen.isPresent() || !onPaper.contains(sessions.participant())) {
        sessions.tellOthers(chosen, session, problems);
      }
      if (chosen.isPresent()) {
        gathering.session(chosen.get(), sessions.history(chosen.get()));
        onPaper.remove(sessions.participant());
      }
    }
    onPaper.forEach(gathering::onPaper);
    return new CollectedAnswers(
        gathering.responses.toString(),
        gathering.ratings.toString(),
        bands(gathering.all),
        gathering.participants,
        gathering.answers);
  }

  private static String bands(Map<Rated, List<Integer>> all) {
    CsvText table = CsvText.bare();
    table.row("area", "schema", "object", "mean", "count", "band", "consistency");
    all.entrySet().stream()
        .sorted(
            Comparator.comparing((Map.Entry<Rated, List<Integer>> entry) -> entry.getKey().area())
                .thenComparing(entry -> entry.getKey().object()))
        .forEach(
            entry -> {
              double mean =
                  entry.getValue().stream().mapToInt(Integer::intValue).average().orElseThrow();
              Band band = Band.of(mean);
              table.row(
                  entry.getKey().area(),
                  entry.getKey().schema(),
                  entry.getKey().object(),
                  String.format(Locale.ROOT, "%.6f", mean),
                  entry.getValue().size(),
                  band.name().toLowerCase(Locale.ROOT).replace('_', '-'),
                  band.consistency().name().toLowerCase(Locale.ROOT));
            });
    return table.toString();
  }
}
