package org.selectiverenderer.chart;

import java.util.List;

/**
 * A chart of values that hold for a while and then change at once, over time: a step curve for each
 * series, from 0 upwards.
 *
 * @param subtitle says what the height of the curves stands for
 * @param curves one to six
 */
public record StepChart(String title, String subtitle, List<Curve> curves) {
  /** The most curves that can be told apart. */
  public static final int MOST = StepChartRenderer.COLOURS.size();

  /**
   * The curve of a series.
   *
   * @param steps in order of time, at least one; the value of the last one holds for no time, it
   *     ends the curve
   */
  public record Curve(String name, List<Step> steps) {
    /** Makes a defensive copy, so that the record is immutable. */
    public Curve {
      steps = List.copyOf(steps);
    }
  }

  /**
   * A value that holds until the next step.
   *
   * @param t time in seconds, at least 0
   * @param value at least 0
   */
  public record Step(double t, double value) {}

  /**
   * Checks the number of curves.
   *
   * @throws IllegalArgumentException if there is none, there are too many, or one has no steps
   */
  public StepChart {
    curves = List.copyOf(curves);
    if (curves.isEmpty()
        || curves.size() > MOST
        || curves.stream().anyMatch(curve -> curve.steps().isEmpty())) {
      throw new IllegalArgumentException("a chart needs one to %d curves".formatted(MOST));
    }
  }
}
