package org.selectiverenderer.statistics.detection;

/**
 * Which answers count, by their confidence: the thesis's three sets of results (6.4), "corrected"
 * for guessing.
 */
public enum ConfidenceLevel {
  ALL("all", "un", 0),
  MODERATE("3-5", "mod", 3),
  HIGH("5", "high", 5);

  private final String spelling;
  private final String heading;
  private final int least;

  ConfidenceLevel(String spelling, String heading, int least) {
    this.spelling = spelling;
    this.heading = heading;
    this.least = least;
  }

  /** The confidences that count, as files name them. */
  public String spelling() {
    return spelling;
  }

  /** As the thesis's Tables 6 to 11 head their columns. */
  public String heading() {
    return heading;
  }

  /** Whether an answer counts; one without confidence counts at {@link #ALL} only. */
  public boolean admits(Response response) {
    return response.confidence() >= least;
  }
}
