package org.selectiverenderer.schema;

import java.util.Locale;
import java.util.Optional;

/** The consistency of an object with the schema of its place (thesis 4.2.2). */
public enum ConsistencyType {
  /** An object expected in the place. */
  CONSISTENT,
  /** An object not expected in the place. */
  INCONSISTENT,
  /** A part of any place, such as a wall, a ceiling or a door. */
  FRAME;

  /** Returns the word for the type in the metadata. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the type of a word, ignoring letter case and surrounding spaces. */
  public static Optional<ConsistencyType> of(String word) {
    for (ConsistencyType type : values()) {
      if (type.spelling().equals(word.strip().toLowerCase(Locale.ROOT))) {
        return Optional.of(type);
      }
    }
    return Optional.empty();
  }
}
