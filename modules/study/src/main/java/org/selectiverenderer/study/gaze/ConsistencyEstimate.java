package org.selectiverenderer.study.gaze;

import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * How consistent an object is with an area, by what participants looked at.
 *
 * @param attention natural logarithm of the attention that it drew relative to what its time in
 *     view and its size let expect; above 0 for an inconsistent object
 * @param deviation standard deviation of {@code attention} given the data
 * @param rating mean expectancy rating towards which the estimate was shrunk, 1 to 6; empty where
 *     it was shrunk towards the mean of the area's objects
 */
public record ConsistencyEstimate(
    String object,
    GazeArea area,
    double attention,
    double deviation,
    OptionalDouble rating,
    Evidence evidence) {

  /**
   * Steepness of the logistic function from attention to degree. An object that draws the attention
   * that its size lets expect has degree 1/2, one that draws twice as much 1 / (1 + 2^3) = 0.11.
   */
  static final double STEEPNESS = 3;

  /** Quantile of the normal distribution for both ends of a 90% interval. */
  private static final double QUANTILE = 1.6448536269514722;

  /** Participants below which nothing is said: one person's interest is not consistency. */
  private static final int FEWEST = 2;

  /**
   * What an estimate rests on.
   *
   * @param participants number of those who had the object in view for at least a second
   * @param inView seconds in which it was in view of all of them together
   * @param dwell seconds in which it was looked at
   * @param fixations number of fixations; of looks in logs without gaze data
   */
  public record Evidence(int participants, double inView, double dwell, int fixations) {}

  /** Returns the degree of consistency, from 0, inconsistent, to 1. */
  public double degree() {
    return degree(attention);
  }

  /** Returns the lower end of the 90% interval of the degree. */
  public double low() {
    return degree(attention + QUANTILE * deviation);
  }

  /** Returns the upper end of the 90% interval of the degree. */
  public double high() {
    return degree(attention - QUANTILE * deviation);
  }

  /**
   * Returns the type that follows: consistent if the interval lies above 1/2, inconsistent if it
   * lies below; empty if it does neither, or if too few participants saw the object.
   */
  public Optional<ConsistencyType> type() {
    if (evidence.participants < FEWEST) {
      return Optional.empty();
    }
    return low() > 0.5
        ? Optional.of(ConsistencyType.CONSISTENT)
        : high() < 0.5 ? Optional.of(ConsistencyType.INCONSISTENT) : Optional.empty();
  }

  private static double degree(double attention) {
    return 1 / (1 + Math.exp(STEEPNESS * attention));
  }

  /**
   * Returns the attention that a mean rating from 1 to 6 lets expect, the inverse of the degree.
   */
  static double expectedAttention(double rating) {
    double degree = Math.max(0.1, Math.min(0.9, (rating - 1) / 5));
    return -Math.log(degree / (1 - degree)) / STEEPNESS;
  }
}
