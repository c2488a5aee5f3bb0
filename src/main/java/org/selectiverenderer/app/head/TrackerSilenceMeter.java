package org.selectiverenderer.app.head;

/**
 * Measures the longest time that a run went on without a new tracker sample, in seconds of the run.
 * Pauses do not count, nor does a slow frame during which samples arrived.
 */
final class TrackerSilenceMeter {
  private double heard = Double.NaN;
  private double longest;

  /**
   * Reports that a frame was stepped.
   *
   * @param time time of the run in seconds, pauses not counted
   * @param fresh whether the frame used a sample that no earlier frame had used
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
