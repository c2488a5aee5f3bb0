package org.selectiverenderer.schema;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What decides the level of one quality, where the condition does not. */
public enum QualityRule {
  /** The areas that the viewer enters and leaves. */
  SELECTIVE,
  /** Nothing: every object has its best level, the least consistent one. */
  HIGH,
  /** Nothing: every object has its worst level, the most consistent one. */
  LOW;

  /** Returns the word on the command line. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the rule of a word on the command line. */
  public static Optional<QualityRule> of(String spelling) {
    return Arrays.stream(values()).filter(r -> r.spelling().equals(spelling)).findFirst();
  }

  /** Returns the choice that stays; not to be asked of {@link #SELECTIVE}. */
  public int choice(SwitchSchemas schemas) {
    return switch (this) {
      case HIGH -> schemas.mostDetailed();
      case LOW -> schemas.leastDetailed();
      case SELECTIVE -> throw new IllegalStateException("areas decide");
    };
  }
}
