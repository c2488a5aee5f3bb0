package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Determines which of several schemas activated together a Switch follows: the last one that its
 * metadata names.
 */
final class SchemaPrecedence {
  private SchemaPrecedence() {}

  static Optional<Integer> choice(List<String> schemas, Map<String, Integer> choices) {
    return schemas.stream()
        .filter(choices::containsKey)
        .reduce((earlier, later) -> later)
        .map(choices::get);
  }
}
