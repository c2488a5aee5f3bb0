package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class SwitchSchemasTest {
  private static SwitchSchemas withDegrees(Degree... degrees) {
    Choice[] choices = new Choice[degrees.length];
    Arrays.setAll(
        choices,
        i -> new Choice(i, Optional.empty(), Optional.ofNullable(degrees[i]), List.of("S")));
    return new SwitchSchemas(List.of(choices));
  }

  @Test
  void theLastSetThatNamesASchemaCounts() {
    assertThat(withDegrees(Degree.LOW, Degree.HIGH).choiceBySchema()).containsEntry("S", 1);
  }

  @Test
  void theLowestDegreeIsTheMostDetailed() {
    SwitchSchemas asInFigure52 = withDegrees(Degree.HIGH, Degree.LOW);
    assertThat(asInFigure52.mostDetailed()).isEqualTo(1);
    assertThat(asInFigure52.leastDetailed()).isZero();
  }

  @Test
  void furtherLevelsAreOrderedByNumber() {
    SwitchSchemas levels = withDegrees(new Degree(0.5), new Degree(0.25), new Degree(0.75));
    assertThat(levels.mostDetailed()).isEqualTo(1);
    assertThat(levels.leastDetailed()).isEqualTo(2);
  }

  @Test
  void aVersionWithoutMetadataIsTheOriginal() {
    SwitchSchemas kitchen =
        new SwitchSchemas(
            List.of(
                Choice.undescribed(0),
                new Choice(1, Optional.empty(), Optional.of(Degree.HIGH), List.of("K"))));
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

  private static Choice typed(ConsistencyType type) {
    return new Choice(0, Optional.of(type), Optional.empty(), List.of());
  }

  @Test
  void degreesAreLowHighOrNumbersFromZeroToOne() {
    assertThat(Degree.of(" HIGH ")).contains(Degree.HIGH);
    assertThat(Degree.of("0")).contains(Degree.LOW);
    assertThat(Degree.of("0.3").orElseThrow().spelling()).isEqualTo("0.3");
    assertThat(Degree.of("1").orElseThrow().spelling()).isEqualTo("high");
    assertThat(Degree.of("1.01")).isEmpty();
    assertThat(Degree.of("NaN")).isEmpty();
    assertThatIllegalArgumentException().isThrownBy(() -> new Degree(-0.1));
  }
}
