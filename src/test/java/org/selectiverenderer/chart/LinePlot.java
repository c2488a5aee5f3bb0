package org.selectiverenderer.chart;

import java.util.List;

/**
 * Curves over two logarithmic axes, on which growth by a power is a straight line; a faint line
 * shows the slope of proportion. Each curve's name stands at its end.
 *
 * @param across what the horizontal axis counts, with its unit
 * @param up what the vertical one measures, with its unit
 * @param curves at most seven
 */
public record LinePlot(String title, String subtitle, String across, String up, List<Curve> curves)
    implements Plot {
  /**
   * @param points from left to right, at least one
   */
  public record Curve(String name, List<Point> points) {
    public Curve {
      points = List.copyOf(points);
    }

    Point last() {
      return points.get(points.size() - 1);
    }
  }

  /** Both above 0 and finite. */
  public record Point(double x, double y) {}

  /**
   * @throws IllegalArgumentException if there are no curves or too many, one has no points, or they
   *     do not go to the right, or one has no logarithm
   */
  public LinePlot {
    curves = List.copyOf(curves);
    if (curves.isEmpty() || curves.size() > SeriesPalette.limit()) {
      throw new IllegalArgumentException(curves.size() + " curves cannot be told apart");
    }
    for (Curve curve : curves) {
      if (curve.points().isEmpty()) {
        throw new IllegalArgumentException(curve.name() + " has no points");
      }
      double before = 0;
      for (Point point : curve.points()) {
        if (!(point.x() > before && point.y() > 0 && point.x() + point.y() < 1e300)) {
          throw new IllegalArgumentException(curve.name() + " cannot go through " + point);
        }
        before = point.x();
      }
    }
  }

  @Override
  public String svg() {
    return new LinePlotRenderer(this).svg();
  }
}
