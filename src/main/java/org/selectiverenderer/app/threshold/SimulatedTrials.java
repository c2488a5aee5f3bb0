package org.selectiverenderer.app.threshold;

import java.util.Optional;
import org.selectiverenderer.experiment.threshold.SimulatedObserver;
import org.selectiverenderer.experiment.threshold.ThresholdSession;
import org.selectiverenderer.experiment.threshold.ThresholdStudy;
import org.selectiverenderer.experiment.threshold.ThresholdTrial;

/** Nobody sits there: a simulated observer answers at once. */
public final class SimulatedTrials implements ThresholdDialogue {
  /** Share of its polygons at which an object's threshold lies, on the way of the ladder. */
  private static final double WAY = 0.5;

  private final SimulatedObserver observer;

  /** The same participant of the same study always answers alike. */
  public SimulatedTrials(ThresholdStudy study, ThresholdPictures pictures, String participant) {
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
