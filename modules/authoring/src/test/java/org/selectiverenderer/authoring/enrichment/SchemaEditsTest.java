package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.SensorSchemas;

class SchemaEditsTest {
  @Test
  void aSensorThatWasAnEmptyElementOpens() {
    EnrichmentScenes scene =
        EnrichmentScenes.with("  <ProximitySensor DEF='DeskProx' size='1 1 1'/>\n");
    scene.perform(
        scene
            .edits()
            .sensor(
                scene.sensor("DeskProx"),
                new SensorSchemas(List.of("Desk"), List.of("Office", "Room"))));
    assertThat(scene.nodes())
        .isEqualTo(
            """
              <ProximitySensor DEF='DeskProx' size='1 1 1'>
                <MetadataSet containerField='metadata' DEF='MetadataSet_DeskProxDefinition' name='DeskProx'>
                  <MetadataString containerField='value' DEF='enterTimeSchemaDefinitionDeskProx' name='enterTimeSchema' value='"Desk"'/>
                  <MetadataString containerField='value' DEF='exitTimeSchemaDefinitionDeskProx' name='exitTimeSchema' value='"Office" "Room"'/>
                </MetadataSet>
              </ProximitySensor>
            """
                .indent(2)
                .replaceFirst("^  ", "  ")
                .replaceAll("(?m)^  ", ""));
    assertThat(scene.sensor("DeskProx").schemas().exit()).containsExactly("Office", "Room");
  }

  @Test
  void aSensorThatWasAnEmptyElementStaysTheSameElementThatItsFormStandsFor() {
    String nodes = "  <ProximitySensor DEF='DeskProx' size='1 1 1'/>\n";
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    EnrichedSensor before = scene.sensor("DeskProx");
    SensorSchemas wanted = new SensorSchemas(List.of("Desk"), List.of());
    scene.perform(scene.edits().sensor(before, wanted));
    assertThat(before.element().attached()).isTrue();
    assertThat(scene.sensor("DeskProx").element()).isSameAs(before.element());
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(nodes);
    assertThat(scene.sensor("DeskProx").element()).isSameAs(before.element());
  }

  @Test
  void aSchemaThatNothingActivatesIsAsGraveAsTheValidatorSays() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
              <ProximitySensor DEF='P' size='1 1 1'>
                <MetadataSet containerField='metadata'>
                  <MetadataString containerField='value' name='enterTimeSchema' value='"Desk"'/>
                </MetadataSet>
              </ProximitySensor>
            """);
    assertThat(scene.enrichment.schemaFindings().values())
        .singleElement()
        .satisfies(
            finding -> {
              assertThat(finding.message()).contains("Desk"); // SR405 and SR406 are warnings
              assertThat(finding.severity()).isEqualTo(Problem.Severity.WARNING);
            });
  }

  @Test
  void aSchemaOfItsOwnLineGetsOneMore() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <ProximitySensor DEF='P'>
             <MetadataSet>
              <MetadataString name="enterTimeSchema" value="Schema1"/>
              <MetadataString name="enterTimeSchema" value="Schema2"/>
             </MetadataSet>
            </ProximitySensor>
            """);
    EnrichedSensor sensor = scene.sensor("P");
    assertThat(sensor.schemas().enter()).containsExactly("Schema1", "Schema2");
    scene.perform(
        scene
            .edits()
            .sensor(sensor, new SensorSchemas(List.of("Schema1", "Schema2", "C"), List.of())));
    assertThat(scene.nodes())
        .contains(
            """
              <MetadataString name="enterTimeSchema" value="Schema2"/>
              <MetadataString containerField='value' DEF='enterTimeSchemaDefinitionP' name='enterTimeSchema' value='"C"'/>
             </MetadataSet>
            """);
    scene.perform(
        scene.edits().sensor(scene.sensor("P"), new SensorSchemas(List.of("C"), List.of())));
    assertThat(scene.nodes()).doesNotContain("Schema1", "Schema2").contains("\"C\"");
  }

  @Test
  void renamingASchemaChangesItsNameOnlyAndEverywhere() {
    String nodes =
        """
        <ProximitySensor DEF='P'><MetadataString name='enterTimeSchemaActivation' value='"A" "B"'/></ProximitySensor>
        <Switch DEF='S'><MetadataSet><MetadataString name='schemaBelonginess' value=' A'/><MetadataString name='title' value='"A"'/></MetadataSet><Shape/></Switch>
        <!-- A -->
        """;
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    scene.perform(scene.edits().renameSchema("A", "Z"));
    assertThat(scene.nodes())
        .isEqualTo(nodes.replace("\"A\" \"B\"", "\"Z\" \"B\"").replace("' A'", "'\"Z\"'"));
    scene.perform(scene.edits().renameSchema("Z", "B"));
    assertThat(scene.sensor("P").schemas().enter()).containsExactly("B");
    assertThat(scene.document.history().names()).containsExactly("Rename A to Z", "Rename Z to B");
    assertThatThrownBy(() -> scene.edits().renameSchema("B", " "))
        .isInstanceOf(EditRejectedException.class);
  }

  @Test
  void removingASchemaTakesItOutEverywhere() {
    EnrichmentScenes scene = EnrichmentScenes.with(SMALL);
    scene.perform(scene.edits().removeSchema("Desk"));
    assertThat(scene.enrichment.schemas()).containsExactly("Dest", "Office");
  }

  @Test
  void aChoiceThatBelongedToARemovedSchemaOnlySaysNothingAnyMore() {
    String plain = "  <Switch DEF='S' whichChoice='0'>\n    <Shape/>\n    <Shape/>\n  </Switch>\n";
    EnrichmentScenes scene = EnrichmentScenes.with(plain);
    ChoiceMetadata desk =
        new ChoiceMetadata(Optional.empty(), Optional.of(ConsistencyDegree.HIGH), List.of("D"));
    scene.perform(scene.edits().choice(scene.switchNode("S"), 1, desk));
    scene.perform(scene.edits().removeSchema("D"));
    assertThat(scene.nodes()).isEqualTo(plain);
  }

  private static final String SMALL =
      """
      <ProximitySensor DEF='P'><MetadataSet>
        <MetadataString name='enterTimeSchema' value='"Desk"'/>
        <MetadataString name='exitTimeSchema' value='"Office"'/>
      </MetadataSet></ProximitySensor>
      <Switch DEF='S' whichChoice='0'><MetadataSet>
        <MetadataSet><MetadataString name='schemaBelonginess' value='"Office"'/></MetadataSet>
        <MetadataSet><MetadataString name='schemaBelonginess' value='"Dest"'/></MetadataSet>
      </MetadataSet><Shape/><Shape/></Switch>
      """;

  @Test
  void aSlipInANameIsFoundAndMended() {
    EnrichmentScenes scene = EnrichmentScenes.with(SMALL);
    List<ElementFinding> findings = scene.enrichment.findings();
    assertThat(findings)
        .extracting(ElementFinding::message)
        .containsExactly(
            "no Switch of the scene belongs to the schema Desk; is Dest meant? It has no effect",
            "no area of the scene activates the schema Dest; is Desk meant? It has no effect");
    ElementFinding last = findings.get(1);
    assertThat(last.located(scene.document)).hasToString("scene.x3d:7:1: " + last.message());
    scene.perform(last.fix().orElseThrow().edit().get());
    assertThat(scene.enrichment.findings()).isEmpty();
    assertThat(scene.document.history().undoName()).contains("Rename Dest to Desk");
  }

  @Test
  void findingsMoveWithTheText() {
    EnrichmentScenes scene = EnrichmentScenes.with(SMALL);
    scene.enrichment.findings();
    scene.document.type(0, 0, "\n\n");
    assertThat(scene.enrichment.findings().get(1).located(scene.document).location().line())
        .isEqualTo(9);
  }
}
