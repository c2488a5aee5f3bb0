package org.selectiverenderer.document.enrichment;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.Choice;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/**
 * The schema metadata of one choice of a Switch: consistency type, degree and schemas.
 *
 * @param schemas the schemas to which the choice belongs, in order
 */
public record ChoiceValues(
    Optional<ConsistencyType> type, Optional<Degree> degree, List<String> schemas) {
  /** No metadata. */
  public static final ChoiceValues NONE =
      new ChoiceValues(Optional.empty(), Optional.empty(), List.of());

  public ChoiceValues {
    schemas = schemas.stream().map(String::strip).filter(s -> !s.isEmpty()).distinct().toList();
  }

  static ChoiceValues of(Choice choice) {
    return new ChoiceValues(choice.type(), choice.degree(), choice.schemas());
  }

  public ChoiceValues with(ConsistencyType other) {
    return new ChoiceValues(Optional.of(other), degree, schemas);
  }

  public ChoiceValues with(Degree other) {
    return new ChoiceValues(type, Optional.of(other), schemas);
  }

  public ChoiceValues with(List<String> other) {
    return new ChoiceValues(type, degree, other);
  }

  public boolean isEmpty() {
    return equals(NONE);
  }
}
