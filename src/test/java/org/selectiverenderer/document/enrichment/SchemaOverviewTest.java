package org.selectiverenderer.document.enrichment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.document.enrichment.SchemaOverview.Cell;
import org.selectiverenderer.document.enrichment.SchemaOverview.Place;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

class SchemaOverviewTest {
  private static Scenes scene(int objects, int versions) {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < objects; i++) {
      nodes.append("  <Switch DEF='S" + i + "'>\n" + "    <Shape/>\n".repeat(versions));
      nodes.append("  </Switch>\n");
    }
    return Scenes.with(nodes.toString());
  }

  private static SchemaOverview overview(Scenes scene) {
    return new SchemaOverview(scene.enrichment, List.of("A", "B"));
  }

  @Test
  void manyCellsAreFilledInOneStep() {
    Scenes scene = scene(50, 2);
    String before = scene.nodes();
    SchemaOverview empty = overview(scene);
    List<Place> column = empty.objects().stream().map(object -> new Place(object, "A")).toList();
    scene.perform(empty.fill(column, Degree.HIGH));
    SchemaOverview filled = overview(scene);
    assertThat(filled.objects())
        .allSatisfy(
            object ->
                assertThat(filled.cell(object, "A"))
                    .contains(cell(1, ConsistencyType.CONSISTENT, Degree.HIGH)));
    assertThat(scene.document.history().names()).containsExactly("Set 50 cells to high");
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(before);
  }

  @Test
  void severalCellsOfOneObjectAreOneEditOfIt() {
    Scenes scene = scene(1, 2);
    SchemaOverview empty = overview(scene);
    EnrichedSwitch object = empty.objects().get(0);
    scene.perform(empty.fill(List.of(new Place(object, "A"), new Place(object, "B")), Degree.LOW));
    assertThat(scene.switchNode("S0").values().get(0).schemas()).containsExactly("A", "B");
  }

  @Test
  void anotherDegreeMovesTheSchemaToAnotherVersion() {
    Scenes scene = scene(1, 3);
    fill(scene, new Degree(0.4));
    assertThat(cell(scene)).isEqualTo(cell(1, ConsistencyType.INCONSISTENT, new Degree(0.4)));
    fill(scene, Degree.HIGH);
    assertThat(cell(scene)).isEqualTo(cell(2, ConsistencyType.CONSISTENT, Degree.HIGH));
    assertThat(scene.switchNode("S0").values().get(1)).isEqualTo(ChoiceValues.NONE);
    scene.perform(overview(scene).clear(List.of(new Place(scene.switchNode("S0"), "A"))));
    assertThat(scene.nodes()).doesNotContain("Metadata");
  }

  private static void fill(Scenes scene, Degree degree) {
    scene.perform(overview(scene).fill(List.of(new Place(scene.switchNode("S0"), "A")), degree));
  }

  private static Cell cell(Scenes scene) {
    return overview(scene).cell(scene.switchNode("S0"), "A").orElseThrow();
  }

  private static Cell cell(int choice, ConsistencyType type, Degree degree) {
    return new Cell(choice, Optional.of(type), Optional.of(degree));
  }
}
