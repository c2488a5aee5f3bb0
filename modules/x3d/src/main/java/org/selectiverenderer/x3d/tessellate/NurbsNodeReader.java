package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.geometry.nurbs.BSplineBasis;
import org.selectiverenderer.geometry.nurbs.NurbsCurve;
import org.selectiverenderer.geometry.nurbs.NurbsSurface;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Reads curves and surfaces from the fields of NURBS nodes (X3D 4.0, 27.3 and 27.4). An invalid
 * knot vector is replaced by a uniform one; weights that are missing or not above 0 are read as 1.
 */
public final class NurbsNodeReader {
  /** The maximum number of segments of a curve or of a surface in one parameter. */
  private static final int MAX_PARTS = 1000;

  private NurbsNodeReader() {}

  /**
   * Reads a NurbsCurve, NurbsCurve2D or NURBS interpolator; empty if it cannot be evaluated.
   *
   * @param problem receives each error as the predicate of a sentence
   */
  public static Optional<NurbsCurve> curve(NodeView node, Consumer<String> problem) {
    double[] points = controlPoints(node, problem);
    int dimensions = node.type().name().equals("NurbsCurve2D") ? 2 : 3;
    int count = points.length / dimensions;
    int order = node.integer("order");
    if (!sound(order, count, points, "order", problem)) {
      return Optional.empty();
    }
    double[] weights = weights(node, count);
    double[] knots = (double[]) node.value("knot");
    boolean closed =
        node.type().field("closed").isPresent()
            && node.bool("closed")
            && !BSplineBasis.fits(order, knots, count)
            && count > order
            && same(points, dimensions, count);
    if (closed) {
      // drop the last point, which equals the first, and repeat the first points, degree many
      int distinct = count - 1;
      double[] around = Arrays.copyOf(points, dimensions * (distinct + order - 1));
      System.arraycopy(points, 0, around, dimensions * distinct, dimensions * (order - 1));
      double[] aroundWeights = Arrays.copyOf(weights, distinct + order - 1);
      System.arraycopy(weights, 0, aroundWeights, distinct, order - 1);
      BSplineBasis basis = BSplineBasis.periodic(order, distinct + order - 1);
      return Optional.of(new NurbsCurve(basis, around, dimensions, aroundWeights));
    }
    BSplineBasis basis = basis(order, knots, count, "knot", problem);
    return Optional.of(new NurbsCurve(basis, points, dimensions, weights));
  }

  private static boolean same(double[] points, int dimensions, int count) {
    int last = dimensions * (count - 1);
    return Arrays.equals(points, 0, dimensions, points, last, last + dimensions);
  }

  /** Reads a surface of {@code uDimension} times {@code vDimension} control points. */
  public static Optional<NurbsSurface> surface(NodeView node, Consumer<String> problem) {
    boolean plane = node.type().name().equals("NurbsTextureCoordinate");
    return surface(node, controlPoints(node, problem), plane ? 2 : 3, problem);
  }

  /** Reads a node's surface with other control points, such as texture coordinates. */
  static Optional<NurbsSurface> surface(
      NodeView node, double[] points, int dimensions, Consumer<String> problem) {
    int columns = node.integer("uDimension");
    int rows = node.integer("vDimension");
    if (columns < 1 || rows < 1 || points.length == 0) {
      return Optional.empty();
    }
    if (points.length / dimensions < (long) columns * rows) {
      problem.accept(
          "has %d control points, too few for its dimensions %d x %d; it is left out"
              .formatted(points.length / dimensions, columns, rows));
      return Optional.empty();
    }
    int uOrder = node.integer("uOrder");
    int vOrder = node.integer("vOrder");
    if (!sound(uOrder, columns, points, "uOrder", problem)
        || !sound(vOrder, rows, new double[0], "vOrder", problem)) {
      return Optional.empty();
    }
    return Optional.of(
        new NurbsSurface(
            basis(uOrder, (double[]) node.value("uKnot"), columns, "uKnot", problem),
            basis(vOrder, (double[]) node.value("vKnot"), rows, "vKnot", problem),
            points,
            dimensions,
            weights(node, columns * rows)));
  }

  private static boolean sound(
      int order, int count, double[] points, String field, Consumer<String> problem) {
    if (count == 0) {
      return false;
    }
    if (order < 2 || order > BSplineBasis.MAX_ORDER || order > count) {
      problem.accept(
          "has %s %d, not from 2 to its number of control points, %d (at most %d); it is left out"
              .formatted(field, order, count, BSplineBasis.MAX_ORDER));
      return false;
    }
    for (double value : points) {
      if (!Double.isFinite(value)) {
        problem.accept("has control points that are not finite; it is left out");
        return false;
      }
    }
    return true;
  }

  private static BSplineBasis basis(
      int order, double[] knots, int count, String field, Consumer<String> problem) {
    if (BSplineBasis.fits(order, knots, count)) {
      return BSplineBasis.of(order, knots, count);
    }
    if (knots.length > 0) {
      problem.accept(
          "has a %s that is not a list of %d ascending values; a uniform knot vector is used"
              .formatted(field, order + count));
    }
    return BSplineBasis.uniform(order, count);
  }

  private static double[] weights(NodeView node, int count) {
    double[] given = (double[]) node.value("weight");
    double[] weights = new double[count];
    for (int i = 0; i < count; i++) {
      weights[i] =
          given.length >= count && given[i] > 0 && given[i] < Double.POSITIVE_INFINITY
              ? given[i]
              : 1;
    }
    return weights;
  }

  /** Returns the control points of a node, from its own field or from a Coordinate node. */
  private static double[] controlPoints(NodeView node, Consumer<String> problem) {
    Object value = node.value("controlPoint");
    if (value instanceof double[] own) {
      return own;
    }
    if (value instanceof float[] own) {
      return doubles(own);
    }
    if (!(value instanceof NodeView coord)) {
      return new double[0];
    }
    return switch (coord.type().name()) {
      case "Coordinate" -> doubles(coord.floats("point"));
      case "CoordinateDouble" -> (double[]) coord.value("point");
      default -> {
        problem.accept("has a " + coord.type().name() + ", which is not supported; it is left out");
        yield new double[0];
      }
    };
  }

  static double[] doubles(float[] floats) {
    double[] doubles = new double[floats.length];
    for (int i = 0; i < floats.length; i++) {
      doubles[i] = floats[i];
    }
    return doubles;
  }

  /**
   * Returns the number of segments for a {@code tessellation} field (X3D 4.0, 27.4.4): its value if
   * positive, its absolute value per control point if negative, 2 per control point if 0.
   */
  static int parts(int tessellation, int controlPoints) {
    long parts =
        tessellation > 0
            ? tessellation
            : (tessellation == 0 ? 2L : -(long) tessellation) * controlPoints;
    return (int) Math.max(1, Math.min(parts, MAX_PARTS));
  }

  /**
   * Returns the points of a NurbsCurve, NurbsCurve2D or ContourPolyline2D as a polyline; none if it
   * is invalid.
   */
  static double[] polyline(NodeView node, Consumer<String> problem) {
    if (node.type().name().equals("ContourPolyline2D")) {
      return controlPoints(node, problem);
    }
    NurbsCurve curve = curve(node, problem).orElse(null);
    if (curve == null) {
      return new double[0];
    }
    int parts = parts(node.integer("tessellation"), curve.basis().count());
    int dimensions = curve.dimensions();
    double[] parameters = curve.basis().parameters(parts);
    double[] all = new double[dimensions * parameters.length];
    for (int i = 0; i < parameters.length; i++) {
      System.arraycopy(curve.at(parameters[i]), 0, all, dimensions * i, dimensions);
    }
    return all;
  }
}
