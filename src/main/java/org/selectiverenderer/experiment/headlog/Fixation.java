package org.selectiverenderer.experiment.headlog;

/**
 * A stretch of time in which the eyes rested.
 *
 * @param object that they rested on; empty for none
 * @param start seconds since the session began
 * @param end likewise
 */
record Fixation(String object, double start, double end) {
  /** Seconds. */
  public double duration() {
    return end - start;
  }
}
