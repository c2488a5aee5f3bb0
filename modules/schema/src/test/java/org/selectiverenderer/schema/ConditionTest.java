package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ConditionTest {
  private static final Set<String> OFFICE = Set.of("DeskSchema", "OfficeSchema");

  private static final SwitchSchemas TRASH_CAN =
      versions(
          version(0, "DeskSchema", ConsistencyDegree.LOW),
          version(1, "OfficeSchema", ConsistencyDegree.HIGH));
  private static final SwitchSchemas KITCHEN =
      versions(
          new VersionMetadata(0, Optional.empty(), Optional.empty(), List.of()),
          version(1, "KitchenSchema", ConsistencyDegree.HIGH));
  private static final SwitchSchemas SHOVEL =
      versions(version(0, "KitchenSchema", ConsistencyDegree.LOW));

  private static VersionMetadata version(int index, String schema, ConsistencyDegree degree) {
    return new VersionMetadata(index, Optional.empty(), Optional.of(degree), List.of(schema));
  }

  private static SwitchSchemas versions(VersionMetadata... choices) {
    return new SwitchSchemas(List.of(choices));
  }

  private static int choice(Condition condition, SwitchSchemas schemas) {
    return condition.initialChoices(Map.of("x", schemas), OFFICE, 0).get("x");
  }

  @Test
  void selectiveLeavesTheSceneAsItIs() {
    assertThat(Condition.SELECTIVE.initialChoices(Map.of("x", TRASH_CAN), OFFICE, 0)).isEmpty();
    assertThat(Condition.SELECTIVE.switches()).isTrue();
    assertThat(Condition.HIGH_LOW.switches()).isFalse();
  }

  @Test
  void highShowsTheVersionOfTheLowestDegree() {
    assertThat(choice(Condition.HIGH, TRASH_CAN)).isZero();
    assertThat(choice(Condition.HIGH, KITCHEN)).isZero();
    SwitchSchemas asInFigure52 =
        versions(
            version(0, "OfficeSchema", ConsistencyDegree.HIGH),
            version(1, "DeskSchema", ConsistencyDegree.LOW));
    assertThat(choice(Condition.HIGH, asInFigure52)).isEqualTo(1);
  }

  @Test
  void highLowShowsObjectsOfVaryingConsistencyHigh() {
    assertThat(choice(Condition.HIGH_LOW, TRASH_CAN)).isZero();
  }

  @Test
  void highLowShowsAConsistentObjectOfARoomWithoutAreasLow() {
    assertThat(choice(Condition.HIGH_LOW, KITCHEN)).isEqualTo(1);
  }

  @Test
  void highLowShowsAnInconsistentObjectHigh() {
    assertThat(choice(Condition.HIGH_LOW, SHOVEL)).isZero();
  }

  @Test
  void highLowCountsOnlySchemasThatAnAreaActivates() {
    SwitchSchemas varyingElsewhere =
        versions(
            version(0, "GarageSchema", ConsistencyDegree.LOW),
            version(1, "OfficeSchema", ConsistencyDegree.HIGH));
    assertThat(choice(Condition.HIGH_LOW, varyingElsewhere)).isEqualTo(1);
  }

  @Test
  void randomShowsHalfOfTheObjectsLowWhateverTheirSchemas() {
    Map<Integer, SwitchSchemas> objects = new LinkedHashMap<>();
    for (int i = 0; i < 70; i++) {
      objects.put(i, i % 2 == 0 ? TRASH_CAN : KITCHEN);
    }

    Map<Integer, Integer> first = Condition.RANDOM.initialChoices(objects, OFFICE, 42);

    assertThat(first.values()).filteredOn(choice -> choice == 1).hasSize(35);
    assertThat(Condition.RANDOM.initialChoices(objects, Set.of(), 42)).isEqualTo(first);
    assertThat(Condition.RANDOM.initialChoices(objects, OFFICE, 43)).isNotEqualTo(first);
  }

  @Test
  void ofAnOddNumberOfObjectsTheLotDecidesOnTheLast() {
    Set<Integer> seen = new java.util.HashSet<>();
    for (long seed = 0; seed < 32; seed++) {
      seen.add(Condition.RANDOM.initialChoices(Map.of("x", TRASH_CAN), OFFICE, seed).get("x"));
    }
    assertThat(seen).containsExactlyInAnyOrder(0, 1);
  }

  @Test
  void namesAreThoseOfTheCommandLine() {
    assertThat(Condition.of("high-low")).contains(Condition.HIGH_LOW);
    assertThat(Condition.of("HIGH")).isEmpty();
    assertThat(Condition.SELECTIVE.spelling()).isEqualTo("selective");
  }
}
