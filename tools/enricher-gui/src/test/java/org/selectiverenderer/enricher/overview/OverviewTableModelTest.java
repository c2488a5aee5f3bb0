package org.selectiverenderer.enricher.overview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.schema.ConsistencyDegree;

class OverviewTableModelTest {
  private final EnrichmentScenes scene =
      EnrichmentScenes.with(
          TestSessions.object("Sink")
              + TestSessions.object("TrashCan")
              + TestSessions.object("Bottle"));
  private final OverviewTableModel model =
      new OverviewTableModel(scene.enrichment, making -> scene.perform(making.get()));

  OverviewTableModelTest() {
    scene.document.addListener(change -> model.refresh());
    model.addSchema("KitchenSchema");
  }

  private List<String> column(int column) {
    List<String> values = new ArrayList<>();
    for (int row = 0; row < model.getRowCount(); row++) {
      values.add(String.valueOf(model.getValueAt(row, column)));
    }
    return values;
  }

  @Test
  void manyCellsAreFilledAsOneStep() {
    model.fill(
        List.of(new CellPosition(0, 1), new CellPosition(2, 1)),
        Optional.of(ConsistencyDegree.HIGH));
    assertThat(column(1)).containsExactly("high", "", "high");
    assertThat(scene.document.history().names()).containsExactly("Set 2 cells to high");
    scene.document.history().undo();
    assertThat(column(1)).containsExactly("", "", "");
  }

  @Test
  void aCellTakesWordsLettersAndNothing() {
    model.setValueAt("l", 0, 1);
    model.setValueAt(" HIGH ", 1, 1);
    model.setValueAt("rubbish", 2, 1);
    assertThat(column(1)).containsExactly("low", "high", "");
    model.setValueAt("", 1, 1);
    assertThat(column(1)).containsExactly("low", "", "");
  }

  @Test
  void writingWhatIsThereAlreadyIsNoStep() {
    model.setValueAt("low", 0, 1);
    model.setValueAt("low", 0, 1);
    assertThat(scene.document.history().names()).hasSize(1);
  }

  @Test
  void rowsAreSortedUpDownAndAsInTheDocument() {
    model.sort(model.order().clicked(0));
    assertThat(column(0)).containsExactly("Bottle", "Sink", "TrashCan");
    model.sort(model.order().clicked(0));
    assertThat(column(0)).containsExactly("TrashCan", "Sink", "Bottle");
    model.sort(model.order().clicked(0));
    assertThat(column(0)).containsExactly("Sink", "TrashCan", "Bottle");
  }

  @Test
  void emptyCellsAreSortedLastBothWays() {
    model.setValueAt("low", 1, 1);
    model.setValueAt("high", 2, 1);
    model.sort(new RowSortKey(1, false));
    assertThat(column(1)).containsExactly("low", "high", "");
    model.sort(new RowSortKey(1, true));
    assertThat(column(1)).containsExactly("high", "low", "");
  }

  @Test
  void rowsStayWhereTheyAreWhileTheyAreEdited() {
    model.filter(new ObjectRowFilter("", ObjectRowFilter.Which.BARE));
    model.setValueAt("high", 0, 1);
    assertThat(column(0)).containsExactly("Sink", "TrashCan", "Bottle");
    model.filter(new ObjectRowFilter("", ObjectRowFilter.Which.BARE));
    assertThat(column(0)).containsExactly("TrashCan", "Bottle");
  }

  @Test
  void rowsAreFilteredByPartOfAName() {
    model.filter(new ObjectRowFilter("CAN", ObjectRowFilter.Which.ALL));
    assertThat(column(0)).containsExactly("TrashCan");
    assertThat(model.objectCount()).isEqualTo(3);
  }

  @Test
  void whatStandsInAnObjectIsInItsRow() {
    assertThat(model.row(scene.switchNode("Switch_TrashCan").choices().get(1).element()))
        .isEqualTo(1);
    assertThat(model.row(scene.document.tree().orElseThrow().root())).isEqualTo(-1);
  }

  @Test
  void anObjectThatIsTypedInGetsARow() {
    int at = scene.document.text().toString().indexOf("</Scene>");
    scene.document.type(at, at, TestSessions.object("Tv"));
    assertThat(column(0)).containsExactly("Sink", "TrashCan", "Bottle", "Tv");
  }

  @Test
  void aColumnNeedsANameOfItsOwn() {
    assertThatThrownBy(() -> model.addSchema(" ")).isInstanceOf(EditRejectedException.class);
    assertThatThrownBy(() -> model.addSchema("KitchenSchema"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("KitchenSchema");
  }

  @Test
  void aRenamedSchemaKeepsItsColumnOnlyUnderItsNewName() {
    model.setValueAt("high", 0, 1);
    scene.perform(scene.edits().renameSchema("KitchenSchema", "CookingSchema"));
    model.renamed("KitchenSchema", "CookingSchema");
    assertThat(model.schemas()).containsExactly("CookingSchema");
    assertThat(column(1)).containsExactly("high", "", "");
  }

  @Test
  void aColumnStaysInItsPlaceWhenItIsFilledFirst() {
    model.addSchema("AtticSchema");
    model.addSchema("BedroomSchema");
    model.setValueAt("high", 0, 3);
    assertThat(model.schemas()).containsExactly("KitchenSchema", "AtticSchema", "BedroomSchema");
  }

  @Test
  void aSchemaThatNoAreaActivatesIsMarked() {
    model.setValueAt("high", 0, 1);
    assertThat(model.mark(1).orElseThrow().message()).contains("no area");
    assertThat(model.mark(0)).isEmpty();
  }

  @Test
  void cellsPutTogetherAreOneStep() {
    model.put(
        Map.of(
            new CellPosition(0, 1), CellInput.of("h").orElseThrow(),
            new CellPosition(1, 1), CellInput.of("0").orElseThrow()));
    assertThat(column(1)).containsExactly("high", "low", "");
    assertThat(scene.document.history().names()).containsExactly("Paste 2 cells");
  }

  @Test
  void anObjectSaysTheDegreesOfItsOtherQualities() {
    EnrichmentScenes jug =
        EnrichmentScenes.with(
            """
            <Switch DEF='Switch_Jug' whichChoice='0'>
              <MetadataSet containerField='metadata'>
                <MetadataSet containerField='metadata' name='fieldQualities'>
                  <MetadataSet containerField='value'>
                    <MetadataString containerField='value' name='quality' value='"textures"'/>
                    <MetadataString containerField='value' name='field' value='"T.url"'/>
                    <MetadataSet containerField='value'>
                      <MetadataString containerField='value' name='schemaBelonginess' value='"Hall"'/>
                      <MetadataString containerField='value' name='value' value='"a.png"'/>
                    </MetadataSet>
                    <MetadataSet containerField='value'>
                      <MetadataString containerField='value' name='schemaBelonginess' value='"Cellar"'/>
                      <MetadataString containerField='value' name='degreeOfConsistency' value='"0.75"'/>
                      <MetadataString containerField='value' name='value' value='"b.png"'/>
                    </MetadataSet>
                  </MetadataSet>
                </MetadataSet>
              </MetadataSet>
              <Group/>
            </Switch>
            """);
    OverviewTableModel table =
        new OverviewTableModel(jug.enrichment, making -> jug.perform(making.get()));
    assertThat(table.longestOthers()).isEqualTo("textures high");
    assertThat(table.others(0, 0)).isEqualTo("textures");
    assertThat(table.schemas()).containsExactlyInAnyOrder("Hall", "Cellar");
    assertThat(table.others(0, 1 + table.schemas().indexOf("Hall"))).isEqualTo("textures low");
    assertThat(table.others(0, 1 + table.schemas().indexOf("Cellar"))).isEqualTo("textures 0.75");
    assertThat(table.explanation(0, 0)).endsWith("other qualities: textures");
    assertThat(model.longestOthers()).isEmpty();
  }
}
