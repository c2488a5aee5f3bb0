package org.selectiverenderer.schema;

import java.util.List;
import java.util.Optional;

/**
 * What the metadata says of one child of a Switch: a version of an object.
 *
 * @param index of the child, from 0
 * @param type empty when the metadata does not say, or not in known words
 * @param degree likewise
 * @param schemas the schemas whose activation shows this child; may be none
 */
public record Choice(
    int index, Optional<ConsistencyType> type, Optional<Degree> degree, List<String> schemas) {
  /** Keeps copies, so that it stays as it is. */
  public Choice {
    schemas = List.copyOf(schemas);
  }

  /** A child of which the metadata says nothing. */
  static Choice undescribed(int index) {
    return new Choice(index, Optional.empty(), Optional.empty(), List.of());
  }

  /**
   * How few polygons this version stands for, from 0 (the most detailed) to 1. Without a degree the
   * type decides: consistent objects are drawn with few polygons, all others with all of theirs
   * (thesis 4.2.1), and so is a version of which nothing is said, the original.
   */
  public double consistency() {
    return degree
        .map(Degree::value)
        .orElse(type.filter(ConsistencyType.CONSISTENT::equals).isPresent() ? 1.0 : 0.0);
  }
}
