package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.models.simplify.ModelSize;
import org.selectiverenderer.models.simplify.SimplificationResult;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Checks the goals of a polygon reduction given as options, and formats messages about them. */
final class ReductionGoalOptions {
  private ReductionGoalOptions() {}

  static SimplificationTarget percent(double percent) {
    if (!(percent > 0 && percent <= 100)) {
      throw CommandException.usage("--vert-percent must be a number above 0 and at most 100");
    }
    return new SimplificationTarget.VertexPercent(percent);
  }

  static SimplificationTarget vertices(int count) {
    if (count < 1) {
      throw CommandException.usage("--vert-count must be a whole number of at least 1");
    }
    return new SimplificationTarget.Vertices(count);
  }

  static SimplificationTarget polygons(int count) {
    if (count < 1) {
      throw CommandException.usage("--polygons must be a whole number of at least 1");
    }
    return new SimplificationTarget.Polygons(count);
  }

  static SimplificationTarget error(@Nullable Double error) {
    if (error == null || !(error >= 0 && error < Double.POSITIVE_INFINITY)) {
      throw CommandException.usage(
          "--max-error must be a number of at least 0, such as 0.01 for one hundredth");
    }
    return new SimplificationTarget.LargestError(error);
  }

  /**
   * Reports a goal that asks for more polygons or vertices than the model has, and returns whether
   * it does.
   */
  static boolean beyond(
      SimplificationTarget goal, ModelSize size, Path file, ProblemCollector problems) {
    boolean beyond =
        goal instanceof SimplificationTarget.Polygons polygons && polygons.count() > size.polygons()
            || goal instanceof SimplificationTarget.Vertices vertices
                && vertices.count() > size.vertices();
    if (beyond) {
      problems.error(
          SourceLocation.of(file.toString()),
          "the model has only %s and %s, fewer than asked for"
              .formatted(polygonText(size.polygons()), vertexText(size.vertices())));
    }
    return beyond;
  }

  static String polygonText(int count) {
    return Pluralizer.of(count, "polygon");
  }

  private static String vertexText(int count) {
    return count == 1 ? "1 vertex" : count + " vertices";
  }

  /** Returns the message that a goal could not be reached. */
  static String shortfall(String subject, SimplificationTarget goal, SimplificationResult reduced) {
    String wanted =
        goal instanceof SimplificationTarget.Polygons polygons
            ? polygonText(polygons.count())
            : goal instanceof SimplificationTarget.Vertices vertices
                ? vertexText(vertices.count())
                : plain(((SimplificationTarget.VertexPercent) goal).percent())
                    + " percent of its vertices";
    return ("%s: %s cannot be reached, because the pieces and seams of the model allow only "
                + "some counts; %s and %s")
            .formatted(
                subject, wanted, polygonText(reduced.polygons()), vertexText(reduced.vertices()))
        + " come nearest";
  }

  /** Formats a number without an exponent. */
  private static String plain(double number) {
    return DecimalFormatter.shortest(number);
  }
}
