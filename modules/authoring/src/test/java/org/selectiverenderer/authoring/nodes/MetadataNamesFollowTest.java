package org.selectiverenderer.authoring.nodes;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;

/** Metadata that is called after an area or an object goes by its new name. */
class MetadataNamesFollowTest {
  private static EnrichmentScenes renamed(String nodes, String from, String to) {
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    scene.perform(
        new NodeEdits(scene.document)
            .rename(scene.document.tree().orElseThrow().named(from).orElseThrow(), to));
    return scene;
  }

  @Test
  void theMetadataOfAnAreaAndWhatRefersToItFollowInOneStep() {
    String nodes =
        """
        <ProximitySensor DEF='Desk'>
          <MetadataSet containerField="metadata" DEF="MetadataSet_DeskDefinition" name="Desk">
            <MetadataString DEF='enterTimeSchemaDefinitionDesk' name='enterTimeSchema' value='"Desk"'/>
            <MetadataString DEF='mine' name='Desk' value='"Desk"'/>
            <MetadataString DEF='exitTimeSchemaDefinitionDesktop' name='exitTimeSchema' value='"A"'/>
          </MetadataSet>
        </ProximitySensor>
        <Group DEF='DeskGroup'><MetadataSet USE='MetadataSet_DeskDefinition'/></Group>
        <Group><MetadataSet DEF='MetadataSet_Desk_2Definition' name='Desk'/></Group>
        """;
    EnrichmentScenes scene = renamed(nodes, "Desk", "Work_$1");
    assertThat(scene.nodes())
        .isEqualTo(
            nodes
                .replace("DEF='Desk'", "DEF='Work_$1'")
                .replace("MetadataSet_DeskDefinition", "MetadataSet_Work_$1Definition")
                .replace("name=\"Desk\"", "name=\"Work_$1\"")
                .replace("DefinitionDesk'", "DefinitionWork_$1'"));
    assertThat(scene.document.history().names()).containsExactly("Rename Desk to Work_$1");
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(nodes);
  }

  @Test
  void theMetadataOfAnObjectIsCalledAfterItsSwitch() {
    String nodes =
        """
        <Switch DEF='Switch_CupDefinition'>
          <MetadataSet containerField='metadata' DEF='MetadataSet_CupDefinition' name='Cup'>
            <MetadataSet containerField='value' DEF='MetadataSetCup_Part1Definition' name='Cup_v1&lt;'>
              <MetadataString DEF='schemaBelonginessDefinitionCup_Part1_2' name='schemaBelonginess'/>
            </MetadataSet>
          </MetadataSet>
          <Group DEF='Cup_v1'/>
        </Switch>
        """;
    assertThat(renamed(nodes, "Switch_CupDefinition", "Switch_PanDefinition").nodes())
        .isEqualTo(
            nodes.replace("Cup", "Pan").replace("<Group DEF='Pan_v1'", "<Group DEF='Cup_v1'"));
  }

  @Test
  void aNameThatIsTakenGetsANumber() {
    String nodes =
        """
        <ProximitySensor DEF='A'>
          <MetadataSet containerField='metadata' DEF='MetadataSet_ADefinition' name='A'/>
        </ProximitySensor>
        <Group DEF='MetadataSet_BDefinition'/>
        """;
    assertThat(renamed(nodes, "A", "B").nodes())
        .contains("DEF='MetadataSet_BDefinition_2' name='B'/>")
        .contains("<Group DEF='MetadataSet_BDefinition'/>");
  }

  @Test
  void fieldsOfSchemasAreNoNamesOfOwners() {
    String nodes =
        """
        <ProximitySensor DEF='enterTimeSchema'>
          <MetadataString DEF='enterTimeSchemaDefinitionenterTimeSchema' name='enterTimeSchema'/>
        </ProximitySensor>
        """;
    assertThat(renamed(nodes, "enterTimeSchema", "B").nodes())
        .contains("DEF='enterTimeSchemaDefinitionB' name='enterTimeSchema'/>");
  }
}
