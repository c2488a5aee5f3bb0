package org.selectiverenderer.enricher.versions;

import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/**
 * The number of vertices that a version is to have, as in thesis Fig 39.
 *
 * @param value percent above 0 to 100, or a number of vertices from 3
 */
record VersionGoal(Kind kind, double value) {
  /** The units of the goal: the parameters of the thesis (2.2.4), and keeping a version. */
  enum Kind {
    PERCENT("versions.percent"),
    COUNT("versions.count"),
    /** Keeps the existing version; the value is its percentage of the original's vertices. */
    KEEP("versions.keep");

    private final String text;

    Kind(String text) {
      this.text = text;
    }

    @Override
    public String toString() {
      return Texts.of(text);
    }
  }

  /** The fewest vertices that make a face. */
  static final int FEWEST = 3;

  static final double LEAST_PERCENT = 0.1;

  static VersionGoal percent(double percent) {
    return new VersionGoal(Kind.PERCENT, percent);
  }

  boolean keeps() {
    return kind == Kind.KEEP;
  }

  /** Converts the goal to another unit, for an original with {@code maxVertex} vertices. */
  VersionGoal as(Kind other, int maxVertex) {
    if (other == kind) {
      return this;
    }
    if (other == Kind.KEEP) {
      return new VersionGoal(other, as(Kind.PERCENT, maxVertex).value());
    }
    if (kind == Kind.KEEP) {
      return percent(value).as(other, maxVertex);
    }
    return other == Kind.COUNT
        ? new VersionGoal(other, Math.round(maxVertex * value / 100)).within(maxVertex)
        : new VersionGoal(other, Math.round(1000.0 * value / Math.max(1, maxVertex)) / 10.0)
            .within(maxVertex);
  }

  /** Returns the goal clamped to what the original can give. */
  VersionGoal within(int maxVertex) {
    double most = kind == Kind.COUNT ? Math.max(FEWEST, maxVertex) : 100;
    double least = kind == Kind.COUNT ? FEWEST : LEAST_PERCENT;
    return new VersionGoal(kind, Math.max(least, Math.min(most, value)));
  }

  SimplificationTarget goal() {
    return kind == Kind.COUNT
        ? new SimplificationTarget.Vertices((int) Math.round(value))
        : new SimplificationTarget.VertexPercent(value);
  }
}
