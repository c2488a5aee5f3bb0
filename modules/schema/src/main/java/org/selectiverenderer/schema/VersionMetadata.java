package org.selectiverenderer.schema;

import java.util.List;
import java.util.Optional;

/**
 * The metadata of one choice of a Switch, which is a version of an object.
 *
 * @param index the index of the child in the Switch, from 0
 * @param type the consistency type; empty if the metadata lacks it or has an unknown word
 * @param degree the degree of consistency; empty if the metadata lacks it or it is invalid
 * @param schemas the schemas whose activation shows this choice; may be none
 */
public record VersionMetadata(
    int index,
    Optional<ConsistencyType> type,
    Optional<ConsistencyDegree> degree,
    List<String> schemas) {
  /** Makes a defensive copy of the list. */
  public VersionMetadata {
    schemas = List.copyOf(schemas);
  }

  /** Returns a choice without metadata. */
  static VersionMetadata undescribed(int index) {
    return new VersionMetadata(index, Optional.empty(), Optional.empty(), List.of());
  }

  /**
   * Returns the consistency of this version, from 0 (most polygons) to 1 (fewest polygons). Without
   * a degree the type decides: consistent objects are drawn with few polygons, all others with all
   * of theirs (thesis 4.2.1). A version without metadata is the original, with all polygons.
   */
  public double consistency() {
    if (degree.isPresent()) {
      return degree.get().value();
    }
    return type.isPresent() && type.get() == ConsistencyType.CONSISTENT ? 1.0 : 0.0;
  }
}
