package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** The goals of an object's versions as the author types them: one number per version. */
final class BatchGoal {
  /** What the numbers mean. */
  enum Kind {
    /** Shares of the vertices to keep, in percent. */
    PERCENT("versions.percent", "50"),
    /** Largest deviations from the original, in percent of its size. */
    TOLERANCE("manyversions.tolerance", "1");

    private final String text;
    private final String usual;

    Kind(String text, String usual) {
      this.text = text;
      this.usual = usual;
    }

    /** Returns the goals to begin with. */
    String usual() {
      return usual;
    }

    @Override
    public String toString() {
      return Texts.of(text);
    }
  }

  private BatchGoal() {}

  /**
   * Reads the numbers, which commas, semicolons or spaces separate; empty if they are not numbers
   * above 0 and at most 100, or are too many.
   */
  static Optional<List<SimplificationTarget>> read(Kind kind, String text) {
    List<SimplificationTarget> goals = new ArrayList<>();
    for (String number : text.strip().split("[,;\\s]+")) {
      double value;
      try {
        value = Double.parseDouble(number);
      } catch (NumberFormatException e) {
        return Optional.empty();
      }
      if (!(value > 0 && value <= 100)) {
        return Optional.empty();
      }
      goals.add(
          kind == Kind.PERCENT
              ? new SimplificationTarget.VertexPercent(value)
              : new SimplificationTarget.LargestError(value / 100));
    }
    return goals.size() > VersionsModel.MOST ? Optional.empty() : Optional.of(goals);
  }
}
