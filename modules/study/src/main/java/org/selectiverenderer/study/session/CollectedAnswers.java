package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerTableKind;
import org.selectiverenderer.study.questionnaire.AnswersCsvBuilder;
import org.selectiverenderer.study.questionnaire.ExpectancyQuestion;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.Respondent;
import org.selectiverenderer.study.questionnaire.StimulusItem;
import org.selectiverenderer.study.questionnaire.TimedAnswer;

/**
 * The collected answers of a study: those of one session of each participant, from its journal, and
 * those given on paper. Finished screens count, also those of unfinished sessions; every answer
 * that does not count, and every session with quality flags, is reported with its file.
 *
 * @param responses answers to recognition lists as CSV, in the form that {@code experiment analyse}
 *     reads
 * @param ratings ratings of expectancy as CSV, in the form that {@code enrich --ratings} reads
 * @param others all other answers as CSV, including those to the form
 * @param scores scores computed from the answers, as CSV
 * @param trials finished trials of blocks as CSV
 * @param bands mean ratings with their bands as CSV, for people
 * @param participants number of participants with answers
 * @param answers number of answers in the tables
 */
public record CollectedAnswers(
    String responses,
    String ratings,
    String others,
    String scores,
    String trials,
    String bands,
    int participants,
    int answers) {

  /** Collects the answers. */
  private static final class Gathering {
    private final LoadedStudy material;
    private final PaperAnswers paper;
    private final ProblemCollector problems;
    private final AnswersCsvBuilder tables = new AnswersCsvBuilder();
    private final RatingBandTable bands = new RatingBandTable();
    private final TrialsTable trials;
    private int participants;
    private int answers;

    Gathering(
        LoadedStudy material, PaperAnswers paper, boolean practice, ProblemCollector problems) {
      trials = new TrialsTable(material, practice);
      this.material = material;
      this.paper = paper;
      this.problems = problems;
    }

    /** Adds a participant with a session. */
    void session(SessionFolder folder, SessionHistory history) {
      SourceLocation place = SourceLocation.of(folder.journal().toString());
      if (history.refused()) {
        problems.info(place, "the participant refused consent");
        paper
            .sheets(folder.participant())
            .values()
            .forEach(
                sheet ->
                    problems.error(
                        sheet.place(),
                        ("participant %s refused consent; the answers from paper " + "are left out")
                            .formatted(folder.participant())));
        return;
      }
      SessionFlagMessages.tell(history, place, problems);
      int before = answers;
      List<String> known = new ArrayList<>();
      List<String> open = new ArrayList<>();
      for (SessionStep step : material.steps()) {
        known.add(step.id());
        if (step instanceof SessionStep.Questions questions) {
          if (leftOut(folder, history, questions)) {
            open.add(step.id());
          } else {
            screen(folder, history, questions, place);
          }
        } else if (step instanceof SessionStep.Form form) {
          form(folder, history, form);
        }
      }
      if (!open.isEmpty()) {
        problems.info(
            place,
            "the participant has left, or not all has arrived; not answered: "
                + String.join(", ", open));
      }
      trials.add(folder.participant(), folder.number(), history);
      answers += history.results().size();
      for (String step : history.answeredSteps()) {
        if (!known.contains(step) && !ofTrial(step)) {
          problems.warning(
              place, "the study no longer has " + step + "; the answers to it are left out");
        }
      }
      unasked(folder.participant());
      participants += answers > before ? 1 : 0;
    }

    /**
     * Returns whether a participant in a browser has not come to a screen. That is nobody's fault,
     * and nothing is lost by it.
     */
    private boolean leftOut(
        SessionFolder folder, SessionHistory history, SessionStep.Questions step) {
      return history.ofWeb()
          && !history.finished(step)
          && history.answers(step).isEmpty()
          && paper.sheet(folder.participant(), step.id()).isEmpty();
    }

    /** Returns whether a step is a trial, whose answers are in the table of trials. */
    private boolean ofTrial(String step) {
      return material.study().design().blocks().stream()
          .anyMatch(block -> step.startsWith(block.name() + "-"));
    }

    /** Adds a participant who answered on paper and has no session. */
    void onPaper(String participant) {
      int before = answers;
      for (SessionStep step : material.steps()) {
        Optional<PaperAnswers.Sheet> typed = paper.sheet(participant, step.id());
        if (step instanceof SessionStep.Questions questions) {
          typed.ifPresent(sheet -> sheet(questions, participant, sheet));
        } else if (step instanceof SessionStep.Form form) {
          typed.ifPresent(sheet -> form(form, participant, sheet));
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

    /** Adds the answers to the form; those on paper if the program does not have them. */
    private void form(SessionFolder folder, SessionHistory history, SessionStep.Form form) {
      Optional<PaperAnswers.Sheet> sheet = paper.sheet(folder.participant(), form.id());
      if (history.finished(form)) {
        sheet.ifPresent(
            typed ->
                problems.error(
                    typed.place(),
                    ("participant %s has answered %s in the program; the answers from paper are "
                            + "left out")
                        .formatted(folder.participant(), form.id())));
        tables.add(
            by(folder.participant(), session(folder), condition(history), form),
            material.form(),
            history.given(form));
      } else {
        sheet.ifPresent(typed -> form(form, folder.participant(), typed));
      }
    }

    private void form(SessionStep.Form form, String participant, PaperAnswers.Sheet sheet) {
      tables.add(by(participant, "", condition(participant), form), material.form(), given(sheet));
    }

    private String condition(String participant) {
      return paper.condition(participant).orElse("");
    }

    private static Map<String, TimedAnswer> given(PaperAnswers.Sheet sheet) {
      Map<String, TimedAnswer> given = new LinkedHashMap<>();
      sheet.answers().forEach((question, answer) -> given.put(question, TimedAnswer.of(answer)));
      return given;
    }

    private static String session(SessionFolder folder) {
      return Integer.toString(folder.number());
    }

    private static String condition(SessionHistory history) {
      return history.group().orElse("");
    }

    private static Respondent by(
        String participant, String session, String condition, SessionStep step) {
      return new Respondent(participant, session, condition, step.id());
    }

    private void screen(
        SessionFolder folder,
        SessionHistory history,
        SessionStep.Questions step,
        SourceLocation place) {
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
        take(
            step,
            by(folder.participant(), session(folder), condition(history), step),
            history.given(step),
            place);
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
      take(step, by(participant, "", condition(participant), step), given(sheet), sheet.place());
    }

    /** Adds the answers to a questionnaire to the tables. */
    private void take(
        SessionStep.Questions step,
        Respondent by,
        Map<String, TimedAnswer> given,
        SourceLocation place) {
      Questionnaire questionnaire = material.questionnaire(step, by.participant());
      tables.add(by, questionnaire, given);
      Map<String, TimedAnswer> left = new LinkedHashMap<>(given);
      for (Question question : questionnaire.questions()) {
        Optional<Answer> answer =
            Optional.ofNullable(left.remove(question.id()))
                .map(TimedAnswer::answer)
                .filter(one -> !one.equals(Answer.NONE) && !question.kind().example());
        answers += answer.isPresent() ? 1 : 0;
        if (question.kind() instanceof ExpectancyQuestion expectancy) {
          StimulusItem item = expectancy.item();
          answer.ifPresent(
              rating ->
                  bands.add(
                      item.area(), item.schema(), item.object(), Integer.parseInt(rating.value())));
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

  /** Collects the answers, without trials of practice blocks. */
  public static CollectedAnswers of(
      LoadedStudy material, OptionalInt session, PaperAnswers paper, ProblemCollector problems)
      throws IOException {
    return of(material, session, false, folder -> true, paper, problems);
  }

  /**
   * Collects the answers.
   *
   * @param session number of the session that counts; empty for each participant's first session
   *     with complete answers, or else the first with any answers
   * @param practice whether trials of practice blocks are in the table of trials
   * @param used which sessions may count
   * @param paper answers on paper, which are used for screens that a session has not finished
   * @throws IOException if a journal cannot be read
   */
  public static CollectedAnswers of(
      LoadedStudy material,
      OptionalInt session,
      boolean practice,
      Predicate<SessionFolder> used,
      PaperAnswers paper,
      ProblemCollector problems)
      throws IOException {
    Gathering gathering = new Gathering(material, paper, practice, problems);
    Set<String> onPaper = paper.participants();
    for (ParticipantSessions sessions : ParticipantSessions.all(material, used)) {
      sessions.tellDamage(problems);
      Optional<SessionFolder> chosen = sessions.chosen(session);
      if (chosen.isPresent() || !onPaper.contains(sessions.participant())) {
        sessions.tellOthers(chosen, session, problems);
      }
      if (chosen.isPresent() && !sessions.excluding(chosen.get()).isEmpty()) {
        SessionFlagMessages.tellExcluded(sessions, chosen.get(), paper, problems);
        onPaper.remove(sessions.participant());
      } else if (chosen.isPresent()) {
        gathering.session(chosen.get(), sessions.history(chosen.get()));
        onPaper.remove(sessions.participant());
      }
    }
    onPaper.forEach(gathering::onPaper);
    return new CollectedAnswers(
        gathering.tables.text(AnswerTableKind.RESPONSES),
        gathering.tables.text(AnswerTableKind.RATINGS),
        gathering.tables.text(AnswerTableKind.ANSWERS),
        gathering.tables.scores(),
        gathering.trials.text(),
        gathering.bands.text(),
        gathering.participants,
        gathering.answers);
  }
}
