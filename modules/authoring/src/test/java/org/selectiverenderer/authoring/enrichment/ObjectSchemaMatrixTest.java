package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Cell;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Place;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

class ObjectSchemaMatrixTest {
  private static EnrichmentScenes scene(int objects, int versions) {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < objects; i++) {
      nodes.append("  <Switch DEF='S" + i + "'>\n" + "    <Shape/>\n".repeat(versions));
      nodes.append("  </Switch>\n");
    }
    return EnrichmentScenes.with(nodes.toString());
  }

  private static ObjectSchemaMatrix overview(EnrichmentScenes scene) {
    return new ObjectSchemaMatrix(scene.enrichment, List.of("A", "B"));
  }

  @Test
  void manyCellsAreFilledInOneStep() {
    EnrichmentScenes scene = scene(50, 2);
    String before = scene.nodes();
    ObjectSchemaMatrix empty = overview(scene);
    List<Place> column = empty.objects().stream().map(object -> new Place(object, "A")).toList();
    scene.perform(empty.fill(column, ConsistencyDegree.HIGH));
    ObjectSchemaMatrix filled = overview(scene);
    assertThat(filled.objects())
        .allSatisfy(
            object ->
                assertThat(filled.cell(object, "A"))
                    .contains(cell(1, ConsistencyType.CONSISTENT, ConsistencyDegree.HIGH)));
    assertThat(scene.document.history().names()).containsExactly("Set 50 cells to high");
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(before);
  }

  @Test
  void severalCellsOfOneObjectAreOneEditOfIt() {
    EnrichmentScenes scene = scene(1, 2);
    ObjectSchemaMatrix empty = overview(scene);
    EnrichedSwitch object = empty.objects().get(0);
    scene.perform(
        empty.fill(List.of(new Place(object, "A"), new Place(object, "B")), ConsistencyDegree.LOW));
    assertThat(scene.switchNode("S0").values().get(0).schemas()).containsExactly("A", "B");
  }

  @Test
  void anotherDegreeMovesTheSchemaToAnotherVersion() {
    EnrichmentScenes scene = scene(1, 3);
    fill(scene, new ConsistencyDegree(0.4));
    assertThat(cell(scene))
        .isEqualTo(cell(1, ConsistencyType.INCONSISTENT, new ConsistencyDegree(0.4)));
    fill(scene, ConsistencyDegree.HIGH);
    assertThat(cell(scene)).isEqualTo(cell(2, ConsistencyType.CONSISTENT, ConsistencyDegree.HIGH));
    assertThat(scene.switchNode("S0").values().get(1)).isEqualTo(ChoiceMetadata.NONE);
    scene.perform(overview(scene).clear(List.of(new Place(scene.switchNode("S0"), "A"))));
    assertThat(scene.nodes()).doesNotContain("Metadata");
  }

  private static void fill(EnrichmentScenes scene, ConsistencyDegree degree) {
    scene.perform(overview(scene).fill(List.of(new Place(scene.switchNode("S0"), "A")), degree));
  }

  private static Cell cell(EnrichmentScenes scene) {
    return overview(scene).cell(scene.switchNode("S0"), "A").orElseThrow();
  }

  private static Cell cell(int choice, ConsistencyType type, ConsistencyDegree degree) {
    return new Cell(choice, Optional.of(type), Optional.of(degree));
  }
}
