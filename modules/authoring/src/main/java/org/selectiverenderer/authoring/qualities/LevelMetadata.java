package org.selectiverenderer.authoring.qualities;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.authoring.enrichment.VersionDegreeMapping;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.VersionMetadata;

/** Makes the metadata of levels: degrees that are spaced evenly, and the schemas asked for. */
final class LevelMetadata {
  private LevelMetadata() {}

  /**
   * @param values the field's value at each level, the best first
   * @param schemas one for each level, or none
   */
  static List<FieldLevel> levels(List<List<String>> values, List<String> schemas) {
    return IntStream.range(0, values.size())
        .mapToObj(
            i ->
                new FieldLevel(
                    new VersionMetadata(
                        i,
                        Optional.empty(),
                        Optional.of(VersionDegreeMapping.degree(i, values.size())),
                        schemas.isEmpty() ? List.of() : List.of(schemas.get(i))),
                    values.get(i)))
        .toList();
  }
}
