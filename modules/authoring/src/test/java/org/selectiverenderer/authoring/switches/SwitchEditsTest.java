package org.selectiverenderer.authoring.switches;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

class SwitchEditsTest {
  private static final String PLAIN =
      """
        <Transform DEF='Transform_Vase' translation='1 0 0'>
          <!-- a note -->
          <Script><![CDATA[
          <kept/>
      ]]></Script>
          <Shape><IndexedFaceSet coordIndex='0 1
      2 -1'/></Shape>
        </Transform>
        <Viewpoint/>
      """;

  private static final String VERSIONS =
      """
        <Switch DEF='Switch_Vase' whichChoice='1'>
          <MetadataSet containerField='metadata' name='Vase'>
            <MetadataSet containerField='value' name='a'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"Office"'/>
            </MetadataSet>
            <MetadataSet containerField='value' name='b'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"Desk"'/>
            </MetadataSet>
          </MetadataSet>
          <Inline DEF='Low' url='"low.x3d"'/>
          <Inline DEF='High' url='"high.x3d"'/>
        </Switch>
      """;

  private static SwitchEdits edits(EnrichmentScenes scene) {
    return new SwitchEdits(scene.enrichment, NodeCatalogue.load());
  }

  private static DocumentElement named(EnrichmentScenes scene, String def) {
    return scene.document.tree().orElseThrow().named(def).orElseThrow();
  }

  private static List<String> told(EnrichmentScenes scene) {
    EnrichedSwitch node = scene.switchNode("Switch_Vase");
    return node.choices().stream()
        .map(
            choice ->
                (choice.index() == node.whichChoice() ? "*" : "")
                    + choice.element().def().orElse(choice.element().name())
                    + choice.values().schemas())
        .toList();
  }

  private static void clean(EnrichmentScenes scene, String before) {
    assertThat(scene.enrichment.switches().get(0).findings()).isEmpty();
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(before);
  }

  @Test
  void aSwitchIsNotPutIntoAnother() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    DocumentElement node = named(scene, "Switch_Vase");
    assertThat(edits(scene).wraps(node)).isFalse();
    assertThatThrownBy(() -> edits(scene).wrap(node, "Switch_2"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessage("Switch Switch_Vase is a Switch already; add a choice to it instead");
  }

  @Test
  void theSwitchOfAnInstanceIsProposedTheNameOfItsPrototype() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
              <ProtoDeclare name='Office chair'><ProtoBody><Group/></ProtoBody></ProtoDeclare>
              <Group DEF='Row'>
                <ProtoInstance name='Office chair'/>
                <ProtoInstance name='Office chair' DEF='First'/>
              </Group>
            """);
    List<DocumentElement> instances = named(scene, "Row").children();
    assertThat(edits(scene).proposedName(instances.get(0))).isEqualTo("Switch_Office_chair");
    assertThat(edits(scene).proposedName(instances.get(1))).isEqualTo("Switch_First");
  }

  @Test
  void whatIsAddedDeclaresTheComponentsThatTheProfileLacks() {
    EnrichmentScenes scene =
        EnrichmentScenes.of(
            """
            <X3D profile='Interchange'>
              <head>
                <meta name='title' content='vase'/>
              </head>
              <Scene>
                <Shape DEF='Vase'/>
              </Scene>
            </X3D>
            """);
    scene.perform(edits(scene).wrap(named(scene, "Vase"), "Switch_Vase"));
    assertThat(scene.document.text().toString())
        .contains("<head>\n    <component name='Grouping' level='2'/>\n    <meta")
        .doesNotContain("Networking");
    scene.perform(edits(scene).addInline(scene.switchNode("Switch_Vase"), "low.x3d"));
    assertThat(scene.document.text().toString())
        .contains(
            "    <component name='Grouping' level='2'/>\n"
                + "    <component name='Networking' level='2'/>\n    <meta");
  }

  @Test
  void aNodeIsWrappedWithItsLayoutAndUnwrappedToTheSameBytes() {
    EnrichmentScenes scene = EnrichmentScenes.with(PLAIN);
    DocumentElement node = named(scene, "Transform_Vase");
    assertThat(edits(scene).proposedName(node)).isEqualTo("Switch_Vase");
    scene.perform(edits(scene).wrap(node, "Switch_Vase"));
    assertThat(scene.nodes())
        .isEqualTo(
            """
              <Switch DEF='Switch_Vase' whichChoice='0'>
                <Transform DEF='Transform_Vase' translation='1 0 0'>
                  <!-- a note -->
                  <Script><![CDATA[
                <kept/>
            ]]></Script>
                  <Shape><IndexedFaceSet coordIndex='0 1
            2 -1'/></Shape>
                </Transform>
              </Switch>
              <Viewpoint/>
            """);
    scene.perform(edits(scene).unwrap(scene.switchNode("Switch_Vase")));
    assertThat(scene.nodes()).isEqualTo(PLAIN);
    assertThat(scene.document.history().names())
        .containsExactly("Make the Switch Switch_Vase", "Unwrap Switch_Vase");
  }

  @Test
  void whatIsNotShownByItselfIsNotWrapped() {
    EnrichmentScenes scene = EnrichmentScenes.with("<Shape><Box DEF='B'/></Shape>\n");
    assertThatThrownBy(() -> edits(scene).wrap(named(scene, "B"), "S"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("choose a Transform, Group, Shape or Inline, not Box");
  }

  @Test
  void choicesAreAddedWithMetadataThatSaysNothing() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    scene.perform(edits(scene).addEmpty(scene.switchNode("Switch_Vase")));
    assertThat(told(scene)).containsExactly("Low[Office]", "*High[Desk]", "Group[]");
    assertThat(scene.nodes()).contains("\n    <Group/>\n  </Switch>");
    clean(scene, VERSIONS);
    scene.perform(edits(scene).addInline(scene.switchNode("Switch_Vase"), "m/x y.x3d"));
    assertThat(scene.nodes()).contains("<Inline DEF='Inline_Vase_v3' url='\"m/x y.x3d\"'/>");
    clean(scene, VERSIONS);
    scene.perform(edits(scene).addCopy(scene.switchNode("Switch_Vase"), 0));
    assertThat(told(scene)).containsExactly("Low[Office]", "*High[Desk]", "Low_2[]");
    clean(scene, VERSIONS);
  }

  @Test
  void aChoiceGoesWithWhatIsSaidOfItAndTheOtherGoesOnShowing() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    scene.perform(edits(scene).remove(scene.switchNode("Switch_Vase"), 0));
    assertThat(told(scene)).containsExactly("*High[Desk]");
    clean(scene, VERSIONS);
    scene.perform(edits(scene).remove(scene.switchNode("Switch_Vase"), 1));
    assertThat(told(scene)).containsExactly("*Low[Office]");
    scene.perform(edits(scene).remove(scene.switchNode("Switch_Vase"), 0));
    assertThat(scene.nodes())
        .isEqualTo("  <Switch DEF='Switch_Vase' whichChoice='-1'>\n  </Switch>\n");
  }

  @Test
  void choicesChangePlacesWithWhatIsSaidOfThem() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    scene.perform(edits(scene).swap(scene.switchNode("Switch_Vase"), 1, 0));
    assertThat(told(scene)).containsExactly("*High[Desk]", "Low[Office]");
    clean(scene, VERSIONS);
    scene.perform(edits(scene).show(scene.switchNode("Switch_Vase"), 0));
    assertThat(scene.nodes()).isEqualTo(VERSIONS.replace("whichChoice='1'", "whichChoice='0'"));
  }

  @Test
  void theShownChoiceTakesTheSwitchsPlaceAndRoutesToItGo() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            VERSIONS
                + "  <ROUTE fromNode='T' fromField='x' toNode='Switch_Vase' toField='whichChoice'/>\n");
    scene.perform(edits(scene).unwrap(scene.switchNode("Switch_Vase")));
    assertThat(scene.nodes()).isEqualTo("  <Inline DEF='High' url='\"high.x3d\"'/>\n");
    EnrichmentScenes shared =
        EnrichmentScenes.with(VERSIONS + "  <Group><Inline USE='Low'/></Group>\n");
    assertThatThrownBy(() -> edits(shared).unwrap(shared.switchNode("Switch_Vase")))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("Low is used elsewhere");
  }
}
