package org.selectiverenderer.study.threshold;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;

/** A process that runs a pilot: answers one trial, says "held" and goes on until its input ends. */
final class PilotHoldingProcess {
  private PilotHoldingProcess() {}

  /**
   * @param args the settings and the participant
   */
  public static void main(String[] args) throws IOException {
    ThresholdStudy study =
        ThresholdStudyReader.read(Path.of(args[0]), new ProblemCollector()).orElseThrow();
    Map<String, StimulusLevels> ladders = ThresholdPilotFixture.ladders(study);
    try (ThresholdSession session =
        ThresholdSession.open(
            study,
            ladders,
            new ThresholdSession.Opening(args[1], "sum", "held 1", true, false),
            new ProblemCollector())) {
      ThresholdTrial trial = session.next().orElseThrow();
      session.answer(trial, trial.right(), 500);
      System.out.println("held");
      System.in.read();
    }
  }
}
