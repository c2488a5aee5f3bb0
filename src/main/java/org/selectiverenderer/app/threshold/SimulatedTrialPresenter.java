package org.selectiverenderer.app.threshold;

import java.util.Optional;
import org.selectiverenderer.study.threshold.SimulatedObserver;
import org.selectiverenderer.study.threshold.ThresholdSession;
import org.selectiverenderer.study.threshold.ThresholdStudy;
import org.selectiverenderer.study.threshold.ThresholdTrial;

/** Lets a simulated observer answer the trials at once. */
public final class SimulatedTrialPresenter implements TrialPresenter {
  /**
   * The position of an object's threshold on the ladder of polygon counts, on a logarithmic scale
   * from the original (0) to the fewest polygons (1).
   */
  private static final double WAY = 0.5;

  private final SimulatedObserver observer;

  /** Creates an observer whose answers depend only on the study and the participant. */
  public SimulatedTrialPresenter(
      ThresholdStudy study, ThresholdStimuli pictures, String participant) {
    observer =
        new SimulatedObserver(
            study.task(),
            pictures.ladders(),
            Math.pow(study.fewest(), WAY),
            study.seed() ^ participant.hashCode());
  }

  @Override
  public boolean introduce() {
    return true;
  }

  @Override
  public Optional<Given> ask(ThresholdTrial trial, ThresholdSession session) {
    return Optional.of(new Given(observer.answer(trial), 0));
  }

  @Override
  public void thanks() {
    // Nobody is there to be thanked.
  }

  @Override
  public void close() {
    // There is no window.
  }
}
