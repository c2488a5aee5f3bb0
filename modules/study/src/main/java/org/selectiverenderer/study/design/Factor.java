package org.selectiverenderer.study.design;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A factor of the design.
 *
 * @param name a column of tables: letters, digits and underscores, beginning with a letter
 * @param scope whether each participant has one of the levels or all of them
 * @param levels at least two
 */
public record Factor(String name, Scope scope, List<Level> levels) {
  /** Whether a factor varies between participants or within each of them. */
  public enum Scope {
    BETWEEN,
    WITHIN;

    /** Returns the spelling in a study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * A level of a factor.
   *
   * @param name a cell of tables
   * @param settings what trials of this level show
   */
  public record Level(String name, TrialSettings settings) {}

  public Factor {
    levels = List.copyOf(levels);
  }

  /** Returns the level with a name. */
  public Optional<Level> level(String wanted) {
    return levels.stream().filter(level -> level.name().equals(wanted)).findFirst();
  }
}
