package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class SwitchSchemasTest {
  private static SwitchSchemas withDegrees(ConsistencyDegree... degrees) {
    VersionMetadata[] choices = new VersionMetadata[degrees.length];
    Arrays.setAll(
        choices,
        i ->
            new VersionMetadata(
                i, Optional.empty(), Optional.ofNullable(degrees[i]), List.of("S")));
    return new SwitchSchemas(List.of(choices));
  }

  @Test
  void theLastSetThatNamesASchemaCounts() {
    assertThat(withDegrees(ConsistencyDegree.LOW, ConsistencyDegree.HIGH).choiceBySchema())
        .containsEntry("S", 1);
  }

  @Test
  void theLowestDegreeIsTheMostDetailed() {
    SwitchSchemas asInFigure52 = withDegrees(ConsistencyDegree.HIGH, ConsistencyDegree.LOW);
    assertThat(asInFigure52.mostDetailed()).isEqualTo(1);
    assertThat(asInFigure52.leastDetailed()).isZero();
  }

  @Test
  void furtherLevelsAreOrderedByNumber() {
    SwitchSchemas levels =
        withDegrees(
            new ConsistencyDegree(0.5), new ConsistencyDegree(0.25), new ConsistencyDegree(0.75));
    assertThat(levels.mostDetailed()).isEqualTo(1);
    assertThat(levels.leastDetailed()).isEqualTo(2);
  }

  @Test
  void aVersionWithoutMetadataIsTheOriginal() {
    SwitchSchemas kitchen =
        new SwitchSchemas(
            List.of(
                VersionMetadata.undescribed(0),
                new VersionMetadata(
                    1, Optional.empty(), Optional.of(ConsistencyDegree.HIGH), List.of("K"))));
    assertThat(kitchen.mostDetailed()).isZero();
    assertThat(kitchen.leastDetailed()).isEqualTo(1);
  }

  @Test
  void withoutAnyDegreeTheFirstVersionIsTheOriginal() {
    assertThat(withDegrees(null, null).mostDetailed()).isZero();
    assertThat(withDegrees(null, null).leastDetailed()).isEqualTo(1);
  }

  @Test
  void withoutADegreeTheTypeDecides() {
    assertThat(typed(ConsistencyType.CONSISTENT).consistency()).isEqualTo(1);
    assertThat(typed(ConsistencyType.INCONSISTENT).consistency()).isZero();
    assertThat(typed(ConsistencyType.FRAME).consistency()).isZero();
  }

  private static VersionMetadata typed(ConsistencyType type) {
    return new VersionMetadata(0, Optional.of(type), Optional.empty(), List.of());
  }

  @Test
  void degreesAreLowHighOrNumbersFromZeroToOne() {
    assertThat(ConsistencyDegree.of(" HIGH ")).contains(ConsistencyDegree.HIGH);
    assertThat(ConsistencyDegree.of("0")).contains(ConsistencyDegree.LOW);
    assertThat(ConsistencyDegree.of("0.3").orElseThrow().spelling()).isEqualTo("0.3");
    assertThat(ConsistencyDegree.of("1").orElseThrow().spelling()).isEqualTo("high");
    assertThat(ConsistencyDegree.of("1.01")).isEmpty();
    assertThat(ConsistencyDegree.of("NaN")).isEmpty();
    assertThatIllegalArgumentException().isThrownBy(() -> new ConsistencyDegree(-0.1));
  }
}
