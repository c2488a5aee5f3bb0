package org.selectiverenderer.study.threshold;

/**
 * An ascending series (method of limits): versions of an object from the fewest polygons upward
 * until the participant recognises it, like pictures that are completed step by step (Snodgrass, J.
 * G. and Corwin, J. 1988. Perceptual identification thresholds for 150 fragmented pictures from the
 * Snodgrass and Vanderwart picture set. Perceptual and Motor Skills 67, 3-36). The right name may
 * be a guess, so the next version must be named too; the threshold is the first of the two.
 */
final class AscendingSeries implements AdaptiveTrack {
  private final StimulusLevels ladder;
  private int rung;
  private boolean named;
  private boolean confirmed;
  private boolean over;

  AscendingSeries(StimulusLevels ladder) {
    this.ladder = ladder;
  }

  @Override
  public int rung() {
    return rung;
  }

  @Override
  public void answered(boolean correct) {
    confirmed = named && correct;
    named = correct;
    over = confirmed || rung == ladder.original();
    if (!over) {
      rung++;
    }
  }

  @Override
  public boolean over() {
    return over;
  }

  @Override
  public ThresholdEstimate estimate() {
    if (!over) {
      return new ThresholdEstimate(ThresholdEstimate.Kind.OPEN, ladder.at(rung));
    }
    if (!confirmed) {
      return new ThresholdEstimate(ThresholdEstimate.Kind.ABOVE, ladder.at(rung));
    }
    return rung == 1
        ? new ThresholdEstimate(ThresholdEstimate.Kind.BELOW, ladder.at(0))
        : new ThresholdEstimate(ThresholdEstimate.Kind.FOUND, ladder.at(rung - 1));
  }
}
