package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.Question;

/** A study of questionnaires alone, which needs no display, and what is done in its sessions. */
abstract class TwoRoomStudyFixture {
  static final SessionOptions OPTIONS =
      new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test");

  @TempDir Path folder;
  Path file = Path.of("");

  @BeforeEach
  void study() throws IOException {
    file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Two rooms", "conditions": ["high", "selective"], "participants": 4,
         "questionnaires": [{"kind": "recognition", "items": "r.csv"},
                            {"kind": "expectancy", "items": "e.csv"}]}
        """);
    Files.writeString(
        folder.resolve("r.csv"),
        """
        area,object,consistency,present,en
        hall,coat,consistent,yes,Coat
        hall,boat,inconsistent,no,Boat
        bath,soap,consistent,yes,Soap
        """);
    Files.writeString(
        folder.resolve("e.csv"),
        "area,schema,object,en\nhall,HallSchema,coat,Coat\nhall,HallSchema,boat,Boat\n");
  }

  /** The study says which flags leave a session out. */
  void exclude(String... flags) throws IOException {
    String list = Arrays.stream(flags).collect(Collectors.joining("\", \"", "[\"", "\"]"));
    Files.writeString(
        file,
        Files.readString(file)
            .replace(
                "\"participants\"", "\"quality\": {\"exclude\": " + list + "}, \"participants\""));
  }

  StudyMaterial material() throws IOException {
    return StudyMaterial.read(file, new ProblemCollector()).orElseThrow();
  }

  Session begin(String id) throws IOException {
    return Session.begin(material(), id, 1, OPTIONS, new ProblemCollector());
  }

  Session resume(String id) throws IOException {
    return Session.resume(material(), id, 1, OPTIONS, new ProblemCollector());
  }

  static List<String> left(Session session) {
    return session.remaining().stream().map(SessionStep::id).toList();
  }

  static void form(Session session) throws IOException {
    SessionStep step = session.remaining().get(0);
    session.began(step, false);
    session.assign("18-22");
    session.finished(step, Map.of());
  }

  static void answerAll(Session session, String value, int confidence) throws IOException {
    SessionStep.Questions step = (SessionStep.Questions) session.remaining().get(0);
    session.began(step, false);
    int place = 0;
    for (Question question : session.questionnaire(step).questions()) {
      place++;
      session.answer(
          step, question, new Answer(value, confidence), OptionalLong.of(1000L * place), place);
    }
    session.finished(step, Map.of());
  }
}
