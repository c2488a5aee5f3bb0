package org.selectiverenderer.cli;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.simplify.ModelSize;
import org.selectiverenderer.polygon.simplify.Simplified;

/** Goals of a reduction from options, and sentences about them. */
final class GoalText {
  private GoalText() {}

  static Goal percent(double percent) {
    if (!(percent > 0 && percent <= 100)) {
      throw CommandFailure.usage("--vert-percent is a number above 0 and at most 100");
    }
    return new Goal.VertexPercent(percent);
  }

  static Goal vertices(int count) {
    if (count < 1) {
      throw CommandFailure.usage("--vert-count is a number from 1");
    }
    return new Goal.Vertices(count);
  }

  static Goal polygons(int count) {
    if (count < 1) {
      throw CommandFailure.usage("--polygons is a number from 1");
    }
    return new Goal.Polygons(count);
  }

  static Goal error(@Nullable Double error) {
    if (error == null || !(error >= 0 && error < Double.POSITIVE_INFINITY)) {
      throw CommandFailure.usage("--max-error is a number from 0, such as 0.01 for a hundredth");
    }
    return new Goal.LargestError(error);
  }

  /** Refuses a goal that has more than the model. */
  static void check(Goal goal, ModelSize size, String subject) {
    if (goal instanceof Goal.Polygons polygons && polygons.count() > size.polygons()) {
      throw CommandFailure.environment(
          "%s has %d polygons; it cannot be reduced to %d"
              .formatted(subject, size.polygons(), polygons.count()));
    }
    if (goal instanceof Goal.Vertices vertices && vertices.count() > size.vertices()) {
      throw CommandFailure.environment(
          "%s has %d vertices; it cannot be reduced to %d"
              .formatted(subject, size.vertices(), vertices.count()));
    }
  }

  /** Why a goal is not met. */
  static String shortfall(String subject, Goal goal, Simplified reduced) {
    String wanted =
        goal instanceof Goal.Polygons polygons
            ? polygons.count() + " polygons"
            : goal instanceof Goal.Vertices vertices
                ? vertices.count() + " vertices"
                : String.format(
                    Locale.ROOT,
                    "%s percent of its vertices",
                    ((Goal.VertexPercent) goal).percent());
    return "%s: %s cannot be reached, as its pieces and seams allow only some counts; %d polygons and"
            .formatted(subject, wanted, reduced.polygons())
        + " %d vertices come nearest".formatted(reduced.vertices());
  }
}
