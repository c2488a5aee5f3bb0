package org.selectiverenderer.app.replication;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.simulation.RecognitionObserver;
import org.selectiverenderer.statistics.simulation.ScoreCalibration;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerTableKind;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.StimulusItem;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.session.SimulatedParticipant;
import org.selectiverenderer.study.session.StudyChecksums;

/**
 * Runs the sessions of the thesis's study with simulated participants, without a display. They
 * answer the memory lists as observers whose scores have the means of Tables 6 to 11, and all other
 * questions at random. Nothing is shown: an exposure is recorded with {@code "shown": false}, and
 * each session has the flag {@code simulated}.
 */
final class ReplicatedSessions {
  /** The objects of one type in one area's list, to the participants of one condition. */
  private record Cell(String area, String type, String condition) {}

  /** The part of a list that a cell answers together. */
  private record ListPart(String area, String type) {}

  private final LoadedStudy material;
  private final long seed;
  private final String software;
  private final Map<String, String> checksums;
  private final Map<ListPart, List<StimulusItem>> lists = new LinkedHashMap<>();
  private final Map<Cell, RecognitionObserver> observers = new HashMap<>();
  private final List<String> held = new ArrayList<>();

  /** Calibrates observers for each list of the study and each condition. */
  ReplicatedSessions(LoadedStudy material, long seed, String software) throws IOException {
    this.material = material;
    this.seed = seed;
    this.software = software;
    checksums = StudyChecksums.of(material);
    for (SessionStep step : material.steps()) {
      if (step instanceof SessionStep.Questions questions) {
        for (Question question : material.questionnaire(questions, "001").questions()) {
          recognition(question)
              .ifPresent(
                  item ->
                      lists
                          .computeIfAbsent(
                              new ListPart(item.area(), item.type()), key -> new ArrayList<>())
                          .add(item));
        }
      }
    }
    // The order of the questions is each participant's own, the draws are not.
    lists.values().forEach(list -> list.sort((a, b) -> a.object().compareTo(b.object())));
    for (ThesisTables.ScoreRow row : ThesisTables.scores()) {
      List<StimulusItem> list = lists.get(new ListPart(row.area(), row.type()));
      if (!row.total() && list != null) {
        ScoreCalibration.Calibrated found =
            ScoreCalibration.of(
                row.levels(), (int) list.stream().filter(StimulusItem::present).count());
        observers.put(new Cell(row.area(), row.type(), row.condition()), found.observer());
        if (!found.exact()) {
          held.add("%s, %s, %s".formatted(row.area(), row.type(), row.condition()));
        }
      }
    }
  }

  /** Returns the cells whose printed means no observer has at all three levels. */
  List<String> held() {
    return List.copyOf(held);
  }

  /** Returns how many present objects the study's list of an area and type has. */
  long present(String area, String type) {
    return lists.getOrDefault(new ListPart(area, type), List.of()).stream()
        .filter(StimulusItem::present)
        .count();
  }

  /** Runs the session of a participant, the first of whom has the number 1. */
  void run(int number, ProblemCollector problems) throws IOException {
    String participant = String.format(Locale.ROOT, "%03d", number);
    SessionOptions options =
        new SessionOptions(Optional.empty(), OptionalDouble.empty(), true, software);
    try (Session session = Session.begin(material, participant, 1, options, checksums, problems)) {
      Map<String, Answer> remembered = new HashMap<>();
      while (!session.remaining().isEmpty()) {
        SessionStep step = session.remaining().get(0);
        session.began(step, false);
        if (step.shows()) {
          session.finished(step, Map.of("shown", false));
        } else {
          answer(session, step, remembered);
          session.finished(step, Map.of());
          if (step instanceof SessionStep.Form) {
            session.assign("simulated");
            remembered.putAll(remembered(number, session.group().orElseThrow().name()));
          }
        }
      }
      session.end();
    }
  }

  /** Draws all answers of a participant to the memory lists, by area and object. */
  private Map<String, Answer> remembered(int number, String condition) {
    Map<String, Answer> answers = new HashMap<>();
    lists.forEach(
        (part, list) -> {
          RecognitionObserver observer =
              observers.get(new Cell(part.area(), part.type(), condition));
          if (observer == null) {
            return; // An area or a condition that the thesis does not have is answered at random.
          }
          SplittableRandom random =
              new SplittableRandom(
                  new SplittableRandom(seed * 1_000_003L + number).nextLong()
                      ^ (part.area() + "/" + part.type()).hashCode());
          List<RecognitionObserver.RecognitionAnswer> drawn =
              observer.answers(list.stream().map(StimulusItem::present).toList(), random);
          for (int i = 0; i < drawn.size(); i++) {
            answers.put(
                key(list.get(i)),
                new Answer(drawn.get(i).yes() ? "yes" : "no", drawn.get(i).confidence()));
          }
        });
    return answers;
  }

  private void answer(Session session, SessionStep step, Map<String, Answer> remembered)
      throws IOException {
    Questionnaire questionnaire = session.questionnaire(step);
    new SimulatedParticipant(
            seed + step.id().hashCode(), session.folder().participant(), material.wording())
        .answer(
            questionnaire,
            session.answers(step),
            new SimulatedParticipant.Listener() {
              @Override
              public void page(QuestionnairePage page, Map<String, Answer> answers) {
                session.shown(step, page, page.asked(answers));
              }

              @Override
              public void answer(Question question, Answer answer, long milliseconds, int place)
                  throws IOException {
                Answer given =
                    recognition(question)
                        .map(item -> remembered.getOrDefault(key(item), answer))
                        .orElse(answer);
                session.answer(step, question, given, OptionalLong.of(milliseconds), place);
              }
            });
  }

  private static String key(StimulusItem item) {
    return item.area() + "/" + item.object();
  }

  private static Optional<StimulusItem> recognition(Question question) {
    return question.kind().table() == AnswerTableKind.RESPONSES
        ? question.kind().about()
        : Optional.empty();
  }
}
