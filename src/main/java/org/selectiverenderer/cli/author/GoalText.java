package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.simplify.ModelSize;
import org.selectiverenderer.polygon.simplify.Simplified;

/** Checks the goals of a polygon reduction given as options, and formats messages about them. */
final class GoalText {
  private GoalText() {}

  static Goal percent(double percent) {
    if (!(percent > 0 && percent <= 100)) {
      throw CommandFailure.usage("--vert-percent must be a number above 0 and at most 100");
    }
    return new Goal.VertexPercent(percent);
  }

  static Goal vertices(int count) {
    if (count < 1) {
      throw CommandFailure.usage("--vert-count must be a whole number of at least 1");
    }
    return new Goal.Vertices(count);
  }

  static Goal polygons(int count) {
    if (count < 1) {
      throw CommandFailure.usage("--polygons must be a whole number of at least 1");
    }
    return new Goal.Polygons(count);
  }

  static Goal error(@Nullable Double error) {
    if (error == null || !(error >= 0 && error < Double.POSITIVE_INFINITY)) {
      throw CommandFailure.usage(
          "--max-error must be a number of at least 0, such as 0.01 for one hundredth");
    }
    return new Goal.LargestError(error);
  }

  /**
   * Reports a goal that asks for more polygons or vertices than the model has, and returns whether
   * it does.
   */
  static boolean beyond(Goal goal, ModelSize size, Path file, Problems problems) {
    boolean beyond =
        goal instanceof Goal.Polygons polygons && polygons.count() > size.polygons()
            || goal instanceof Goal.Vertices vertices && vertices.count() > size.vertices();
    if (beyond) {
      problems.error(
          Location.of(file.toString()),
          "the model has only %s and %s, fewer than asked for"
              .formatted(polygonText(size.polygons()), vertexText(size.vertices())));
    }
    return beyond;
  }

  static String polygonText(int count) {
    return Counted.of(count, "polygon");
  }

  private static String vertexText(int count) {
    return count == 1 ? "1 vertex" : count + " vertices";
  }

  /** Returns the message that a goal could not be reached. */
  static String shortfall(String subject, Goal goal, Simplified reduced) {
    String wanted =
        goal instanceof Goal.Polygons polygons
            ? polygonText(polygons.count())
            : goal instanceof Goal.Vertices vertices
                ? vertexText(vertices.count())
                : plain(((Goal.VertexPercent) goal).percent()) + " percent of its vertices";
    return ("%s: %s cannot be reached, because the pieces and seams of the model allow only "
                + "some counts; %s and %s")
            .formatted(
                subject, wanted, polygonText(reduced.polygons()), vertexText(reduced.vertices()))
        + " come nearest";
  }

  /** Formats a number without an exponent. */
  private static String plain(double number) {
    return DecimalText.shortest(number);
  }
}
