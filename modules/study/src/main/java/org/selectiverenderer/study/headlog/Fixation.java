package org.selectiverenderer.study.headlog;

/**
 * A fixation: a period in which the gaze direction rested.
 *
 * @param object the object that the gaze rested on; empty for none
 * @param start seconds since the session began
 * @param end seconds since the session began
 */
record Fixation(String object, double start, double end) {
  /** Returns the duration in seconds. */
  public double duration() {
    return end - start;
  }
}
