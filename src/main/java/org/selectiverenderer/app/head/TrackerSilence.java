package org.selectiverenderer.app.head;

/**
 * How long a tracker fell silent at most while a run went on, in seconds of the run: pauses do not
 * count, nor does a frame that took long though records came.
 */
final class TrackerSilence {
  private double heard = Double.NaN;
  private double longest;

  /**
   * A frame was stepped.
   *
   * @param time of the run, in seconds
   * @param fresh whether it used a record that no frame before it had used
   */
  void frame(double time, boolean fresh) {
    if (fresh || Double.isNaN(heard)) {
      heard = time;
    } else {
      longest = Math.max(longest, time - heard);
    }
  }

  double longest() {
    return longest;
  }
}
