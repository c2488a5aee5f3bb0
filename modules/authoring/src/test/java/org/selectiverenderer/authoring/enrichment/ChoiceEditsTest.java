package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.x3d.source.DocumentElement;

class ChoiceEditsTest {
  private static final ChoiceMetadata DESK =
      ChoiceMetadata.NONE
          .with(ConsistencyType.INCONSISTENT)
          .with(ConsistencyDegree.LOW)
          .with(List.of("DeskSchema"));

  private static final String PLAIN =
      """
        <Switch DEF='Switch_TrashCan' whichChoice='1'>
          <Inline url='"a_v1.x3d"'/>
          <Inline url='"a_v2.x3d"'/>
        </Switch>
      """;

  private static final String ENRICHED =
      """
        <Switch DEF='Switch_TrashCan' whichChoice='1'>
          <MetadataSet containerField='metadata' DEF='MetadataSet_TrashCanDefinition' name='TrashCan'>
            <MetadataSet containerField='value' DEF='MetadataSetTrashCan_Part1Definition' name='TrashCan_v1'>
              <MetadataString containerField='value' DEF='consistencyTypeDefinitionTrashCan_Part1' name='consistencyType' value='"inconsistent"'/>
              <MetadataString containerField='value' DEF='degreeOfConsistencyDefinitionTrashCan_Part1' name='degreeOfConsistency' value='"low"'/>
              <MetadataString containerField='value' DEF='schemaBelonginessDefinitionTrashCan_Part1' name='schemaBelonginess' value='"DeskSchema"'/>
            </MetadataSet>
            <MetadataSet containerField='value' DEF='MetadataSetTrashCan_Part2Definition' name='TrashCan_v2'/>
          </MetadataSet>
          <Inline url='"a_v1.x3d"'/>
          <Inline url='"a_v2.x3d"'/>
        </Switch>
      """;

  private static EnrichmentScenes described(String nodes, int choice, ChoiceMetadata values) {
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    EnrichedSwitch node = scene.enrichment.switches().get(0);
    scene.perform(scene.edits().choice(node, choice, values));
    assertThat(scene.enrichment.switches().get(0).values().get(choice)).isEqualTo(values);
    return scene;
  }

  @Test
  void metadataIsNamedAsInTheThesisAndIndentedAsItsNeighbours() {
    assertThat(described(PLAIN, 0, DESK).nodes()).isEqualTo(ENRICHED);
  }

  @Test
  void undoingIsNamedAndGivesTheTextBack() {
    EnrichmentScenes scene = described(PLAIN, 0, DESK);
    assertThat(scene.document.history().undoName())
        .contains("Describe choice 0 of Switch_TrashCan");
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(PLAIN);
    assertThat(scene.switchNode("Switch_TrashCan").enriched()).isFalse();
  }

  @Test
  void sayingWhatIsSaidAlreadyIsNoStep() {
    EnrichmentScenes scene = described(ENRICHED, 0, DESK);
    assertThat(scene.document.history().undoName()).isEmpty();
  }

  @Test
  void oneFieldChangesOneValue() {
    assertThat(described(ENRICHED, 0, DESK.with(new ConsistencyDegree(0.25))).nodes())
        .isEqualTo(ENRICHED.replace("\"low\"", "\"0.25\""));
  }

  @Test
  void severalSchemasStandInOneString() {
    assertThat(
            described(ENRICHED, 0, DESK.with(List.of("DeskSchema", "Tom's \"A\\B\" & <c>")))
                .nodes())
        .isEqualTo(
            ENRICHED.replace(
                "'\"DeskSchema\"'", "'\"DeskSchema\" \"Tom&apos;s \\\"A\\\\B\\\" &amp; &lt;c>\"'"));
  }

  @Test
  void theOtherChoiceFillsTheSetThatHeldItsPlace() {
    ChoiceMetadata frame = ChoiceMetadata.NONE.with(ConsistencyType.FRAME);
    assertThat(described(ENRICHED, 1, frame).nodes())
        .isEqualTo(
            ENRICHED.replace(
                " name='TrashCan_v2'/>\n",
                " name='TrashCan_v2'>\n"
                    + "        <MetadataString containerField='value'"
                    + " DEF='consistencyTypeDefinitionTrashCan_Part2' name='consistencyType'"
                    + " value='\"frame\"'/>\n      </MetadataSet>\n"));
  }

  @Test
  void clearingTheLastChoiceTakesTheMetadataAway() {
    assertThat(described(ENRICHED, 0, ChoiceMetadata.NONE).nodes()).isEqualTo(PLAIN);
  }

  @Test
  void clearingOneFieldTakesItsLineAway() {
    EnrichmentScenes scene =
        described(
            ENRICHED,
            0,
            ChoiceMetadata.NONE.with(ConsistencyDegree.LOW).with(List.of("DeskSchema")));
    assertThat(scene.nodes())
        .isEqualTo(ENRICHED.replaceFirst("\n *<MetadataString [^\n]*consistencyType' [^\n]*", ""));
  }

  @Test
  void namesNeverCollide() {
    String taken = "  <Group DEF='schemaBelonginessDefinitionTrashCan_Part1'/>\n";
    assertThat(described(taken + PLAIN, 0, DESK).nodes())
        .isEqualTo(
            taken
                + ENRICHED.replace(
                    "DEF='schemaBelonginessDefinitionTrashCan_Part1'",
                    "DEF='schemaBelonginessDefinitionTrashCan_Part1_2'"));
  }

  @Test
  void switchesWithoutANameGetNamesThatDiffer() {
    String two = "<Switch><Shape/></Switch>\n<Switch><Shape/></Switch>\n";
    EnrichmentScenes scene = described(two, 0, DESK);
    EnrichedSwitch second = scene.enrichment.switches().get(1);
    assertThat(second.name()).isEqualTo("Switch#2");
    scene.perform(scene.edits().choice(second, 0, DESK));
    assertThat(scene.nodes())
        .contains("DEF='MetadataSet_Switch1Definition'", "DEF='MetadataSet_Switch2Definition'");
  }

  @Test
  void aSwitchOnOneLineStaysOnOne() {
    assertThat(described("<Switch DEF=\"S\"><Shape/><Shape/></Switch>\n", 0, DESK).nodes())
        .startsWith(
            "<Switch DEF=\"S\"><MetadataSet containerField=\"metadata\""
                + " DEF=\"MetadataSet_SDefinition\"")
        .contains("value='\"DeskSchema\"'/></MetadataSet>")
        .endsWith("</MetadataSet><Shape/><Shape/></Switch>\n")
        .containsOnlyOnce("\n");
  }

  @Test
  void tabsAndCrLfAreKeptTo() {
    String windows = PLAIN.replace("  ", "\t").replace("\n", "\r\n");
    assertThat(described(windows, 0, DESK).nodes())
        .isEqualTo(ENRICHED.replace("  ", "\t").replace("\n", "\r\n"));
  }

  @Test
  void metadataOfOtherKindsIsKept() {
    String other =
        "<MetadataSet name='author' containerField='metadata'><!-- x --><MetadataString name='who'"
            + " value='\"me\"'/></MetadataSet>";
    String nodes = PLAIN.replaceFirst("    <Inline", "    " + other + "\n    <Inline");
    EnrichmentScenes scene = described(nodes, 1, DESK);
    assertThat(scene.nodes()).contains("<MetadataSet name='author'", "<!-- x -->", "name='who'");
    assertThat(scene.enrichment.findings()).allMatch(f -> f.message().contains("DeskSchema"));
  }

  @Test
  void setsOfAnotherKindMoveIntoOursAfterTheChoices() {
    String other =
        "<MetadataSet name='a'><MetadataSet name='b'/><MetadataSet name='c'/></MetadataSet>";
    EnrichmentScenes scene =
        described(PLAIN.replaceFirst("    <Inline", "    " + other + "\n    <Inline"), 0, DESK);
    assertThat(scene.nodes())
        .contains("      " + other.replace("name='a'", "name='a' containerField='value'") + "\n");
    assertThat(scene.switchNode("Switch_TrashCan").findings()).isEmpty();
  }

  @Test
  void aStringOfAnotherKindMovesIntoOurs() {
    String other = "<MetadataString name='who' value='\"me\"' containerField=\"metadata\"/>";
    EnrichmentScenes scene =
        described(PLAIN.replaceFirst("    <Inline", "    " + other + "\n    <Inline"), 0, DESK);
    assertThat(scene.nodes())
        .contains("      " + other.replace("\"metadata\"", "\"value\"") + "\n");
  }

  @Test
  void stringsThatDescribeTheFirstChoiceStayAsLongAsThereIsNoMoreToSay() {
    String loose =
        "<MetadataSet><MetadataString name='schemaBelonginess' value='\"A\"'/></MetadataSet>";
    String nodes = PLAIN.replaceFirst("    <Inline", "    " + loose + "\n    <Inline");
    ChoiceMetadata b = ChoiceMetadata.NONE.with(List.of("B"));
    assertThat(described(nodes, 0, b).nodes()).isEqualTo(nodes.replace("\"A\"", "\"B\""));
    EnrichmentScenes both = described(nodes, 1, b);
    assertThat(both.switchNode("Switch_TrashCan").values().get(0).schemas()).containsExactly("A");
    assertThat(both.switchNode("Switch_TrashCan").findings()).isEmpty();
  }

  @Test
  void metadataThatOthersUseIsNotChanged() {
    String used =
        PLAIN.replaceFirst(
                "    <Inline",
                "    <MetadataSet DEF='M'><MetadataSet><MetadataString DEF='N'"
                    + " name='schemaBelonginess' value='\"A\"'/></MetadataSet></MetadataSet>\n"
                    + "    <Inline")
            + "  <Switch DEF='Other'><MetadataSet USE='M'/><Shape/></Switch>\n"
            + "  <Switch DEF='Third'><MetadataSet><MetadataSet><MetadataString"
            + " USE='N'/></MetadataSet></MetadataSet><Shape/></Switch>\n";
    EnrichmentScenes scene = EnrichmentScenes.with(used);
    assertThat(scene.switchNode("Other").values().get(0).schemas()).containsExactly("A");
    assertThatThrownBy(() -> scene.edits().choice(scene.switchNode("Switch_TrashCan"), 0, DESK))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageStartingWith("scene.x3d:4:")
        .hasMessageContaining("'N' is also used elsewhere");
    scene.perform(scene.edits().choice(scene.switchNode("Other"), 0, DESK));
    assertThat(scene.switchNode("Other").values()).containsExactly(DESK);
    scene.perform(scene.edits().choice(scene.switchNode("Third"), 0, DESK));
    assertThat(scene.switchNode("Third").values()).containsExactly(DESK);
    assertThat(scene.switchNode("Switch_TrashCan").values().get(0).schemas()).containsExactly("A");
  }

  @Test
  void unknownNodesAreNoChoicesAsForTheReader() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Switch DEF='S'><Unknown/><Shape/><ROUTE/><ProtoInstance name='p'/></Switch>\n");
    assertThat(scene.switchNode("S").choices())
        .extracting(choice -> choice.element().name())
        .containsExactly("Shape", "ProtoInstance");
  }

  @Test
  void theElementsAroundAnEditStayTheSameObjects() {
    EnrichmentScenes scene = EnrichmentScenes.with(PLAIN + PLAIN.replace("TrashCan", "Mug"));
    List<DocumentElement> before =
        List.of(
            scene.switchNode("Switch_TrashCan").element(),
            scene.switchNode("Switch_TrashCan").choices().get(1).element(),
            scene.switchNode("Switch_Mug").element());
    scene.perform(scene.edits().choice(scene.switchNode("Switch_TrashCan"), 0, DESK));
    assertThat(before).allMatch(DocumentElement::attached);
    assertThat(scene.switchNode("Switch_TrashCan").choices().get(1).element())
        .isSameAs(before.get(1));
    assertThat(scene.document.text(before.get(2))).startsWith("<Switch DEF='Switch_Mug'");
  }

  @Test
  void aBrokenTextIsNotEdited() {
    EnrichmentScenes scene = EnrichmentScenes.of("<X3D><Scene></X3D>");
    assertThat(scene.enrichment.switches()).isEmpty();
    assertThatThrownBy(() -> scene.edits().renameSchema("A", "B"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("correct it in the source view first");
  }
}
