package org.selectiverenderer.study.threshold;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

/** A pilot about five objects without pictures, and participants who are simulated. */
abstract class ThresholdPilotFixture {
  static final StimulusLevels LADDER =
      new StimulusLevels(List.of(20, 30, 44, 65, 95, 140, 205, 300, 440, 640, 940, 1400, 2000));

  @TempDir Path folder;
  final ProblemCollector problems = new ProblemCollector();
  Path file = Path.of("");

  @BeforeEach
  void settings() throws IOException {
    file = folder.resolve("threshold.json");
    Files.writeString(folder.resolve("room.x3d"), "<X3D/>");
    write("tell-apart", "");
  }

  void write(String task, String more) throws IOException {
    Files.writeString(
        file,
        """
        {"name": "Pilot", "scene": "room.x3d", "task": "%s", "seed": 7, %s
         "objects": [{"object": "Vase"}, {"object": "Mug"}, {"object": "Lamp"},
                     {"object": "Clock"}, {"object": "Book", "name": "a book"}]}
        """
            .formatted(task, more));
  }

  ThresholdStudy study() throws IOException {
    return ThresholdStudyReader.read(file, new ProblemCollector()).orElseThrow();
  }

  static Map<String, StimulusLevels> ladders(ThresholdStudy study) {
    Map<String, StimulusLevels> ladders = new LinkedHashMap<>();
    study.objects().forEach(judged -> ladders.put(judged.object(), LADDER));
    return ladders;
  }

  ThresholdSession open(String participant, boolean resume) throws IOException {
    ThresholdStudy study = study();
    return ThresholdSession.open(
        study,
        ladders(study),
        new ThresholdSession.Opening(participant, "sum", "test 1", true, resume),
        problems);
  }

  static SimulatedObserver observer(ThresholdStudy study, double share, long seed) {
    return new SimulatedObserver(study.task(), ladders(study), share, seed);
  }

  /** Answers so many trials, or all that are left. */
  static void answer(ThresholdSession session, SimulatedObserver observer, int most)
      throws IOException {
    for (int i = 0; i < most && session.next().isPresent(); i++) {
      ThresholdTrial trial = session.next().get();
      session.answer(trial, observer.answer(trial), 500);
    }
  }

  List<String> log(String participant) throws IOException {
    return Files.readAllLines(folder.resolve("threshold/sub-" + participant + "/trials.jsonl"));
  }

  List<String> told() {
    return problems.list().stream().map(Problem::toString).toList();
  }
}
