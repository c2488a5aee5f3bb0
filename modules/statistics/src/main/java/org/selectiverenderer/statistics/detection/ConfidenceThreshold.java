package org.selectiverenderer.statistics.detection;

/**
 * The lowest confidence with which an answer counts: the thesis's three sets of results (6.4),
 * which are "corrected" for guessing.
 */
public enum ConfidenceThreshold {
  /** All answers. */
  ALL("all", "all", "all answers", 0),
  /** Answers with a confidence of 3 to 5. */
  MODERATE("3-5", "conf. 3–5", "confidence 3–5", 3),
  /** Answers with a confidence of 5. */
  HIGH("5", "conf. 5", "confidence 5", 5);

  private final String spelling;
  private final String heading;
  private final String title;
  private final int least;

  ConfidenceThreshold(String spelling, String heading, String title, int least) {
    this.spelling = spelling;
    this.heading = heading;
    this.title = title;
    this.least = least;
  }

  /** Returns the confidences that count, as files name them. */
  public String spelling() {
    return spelling;
  }

  /**
   * Returns the heading of table columns. The thesis's Tables 6 to 11 have "un", "mod" and "high",
   * the last of which names a condition too.
   */
  public String heading() {
    return heading;
  }

  /** Returns the name of the level in sentences. */
  public String title() {
    return title;
  }

  /** Returns whether an answer counts; one without a confidence counts at {@link #ALL} only. */
  public boolean admits(Response response) {
    return response.confidence() >= least;
  }
}
