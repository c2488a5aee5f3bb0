package org.selectiverenderer.experiment.headlog;

/**
 * A stretch of time in which one object was in the middle of the view.
 *
 * @param start seconds since the session began
 * @param end likewise
 * @param version that it was shown in at the start, -1 for an object without versions
 */
record Dwell(String object, double start, double end, int version) {
  /** Seconds. */
  public double duration() {
    return end - start;
  }
}
