package org.selectiverenderer.schema;

import java.util.Locale;
import java.util.Optional;

/** How an object relates to the schema of the place where it stands (thesis 4.2.2). */
public enum ConsistencyType {
  /** Expected there. */
  CONSISTENT,
  /** Not expected there. */
  INCONSISTENT,
  /** Part of any place, such as a wall, a ceiling or a door. */
  FRAME;

  /** The word in the metadata. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The type of that word, in any case and with spaces around it. */
  public static Optional<ConsistencyType> of(String word) {
    for (ConsistencyType type : values()) {
      if (type.spelling().equals(word.strip().toLowerCase(Locale.ROOT))) {
        return Optional.of(type);
      }
    }
    return Optional.empty();
  }
}
