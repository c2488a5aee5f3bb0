package org.selectiverenderer.enricher.versions;

import org.selectiverenderer.polygon.simplify.Goal;

/**
 * How many vertices a version is to have, as thesis Fig 39 asks for it.
 *
 * @param value percent above 0 to 100, or a number of vertices from 3
 */
record VersionGoal(Kind kind, double value) {
  /** The parameters of the thesis (2.2.4). */
  enum Kind {
    PERCENT("Vert Percent"),
    COUNT("Vert Count");

    private final String label;

    Kind(String label) {
      this.label = label;
    }

    @Override
    public String toString() {
      return label;
    }
  }

  /** The fewest vertices that make a face. */
  static final int FEWEST = 3;

  static final double LEAST_PERCENT = 0.1;

  static VersionGoal percent(double percent) {
    return new VersionGoal(Kind.PERCENT, percent);
  }

  /** The same goal said the other way, of an original with so many vertices. */
  VersionGoal as(Kind other, int maxVertex) {
    if (other == kind) {
      return this;
    }
    return other == Kind.COUNT
        ? new VersionGoal(other, Math.round(maxVertex * value / 100)).within(maxVertex)
        : new VersionGoal(other, Math.round(1000.0 * value / Math.max(1, maxVertex)) / 10.0)
            .within(maxVertex);
  }

  /** The same goal within what the original can give. */
  VersionGoal within(int maxVertex) {
    double most = kind == Kind.PERCENT ? 100 : Math.max(FEWEST, maxVertex);
    double least = kind == Kind.PERCENT ? LEAST_PERCENT : FEWEST;
    return new VersionGoal(kind, Math.max(least, Math.min(most, value)));
  }

  Goal goal() {
    return kind == Kind.PERCENT
        ? new Goal.VertexPercent(value)
        : new Goal.Vertices((int) Math.round(value));
  }
}
