package org.selectiverenderer.authoring.enrichment;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.VersionMetadata;

/**
 * The schema metadata of one choice of a Switch: consistency type, degree and schemas.
 *
 * @param schemas the schemas to which the choice belongs, in order
 */
public record ChoiceMetadata(
    Optional<ConsistencyType> type, Optional<ConsistencyDegree> degree, List<String> schemas) {
  /** No metadata. */
  public static final ChoiceMetadata NONE =
      new ChoiceMetadata(Optional.empty(), Optional.empty(), List.of());

  public ChoiceMetadata {
    schemas = schemas.stream().map(String::strip).filter(s -> !s.isEmpty()).distinct().toList();
  }

  static ChoiceMetadata of(VersionMetadata choice) {
    return new ChoiceMetadata(choice.type(), choice.degree(), choice.schemas());
  }

  public ChoiceMetadata with(ConsistencyType other) {
    return new ChoiceMetadata(Optional.of(other), degree, schemas);
  }

  public ChoiceMetadata with(ConsistencyDegree other) {
    return new ChoiceMetadata(type, Optional.of(other), schemas);
  }

  public ChoiceMetadata with(List<String> other) {
    return new ChoiceMetadata(type, degree, other);
  }

  public boolean isEmpty() {
    return equals(NONE);
  }
}
