package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.ConsistencyDegree;

class MetadataTableTest {
  private static final String NODES =
      """
      <Switch DEF='Switch_A'>
        <Shape/>
        <Shape/>
      </Switch>
      <ProximitySensor DEF='Prox'/>
      """;

  private final ProblemCollector problems = new ProblemCollector();

  private Optional<Edit> edit(EnrichmentScenes scene, String table) {
    return MetadataTable.edit(
        scene.enrichment, "m.csv", table.getBytes(StandardCharsets.UTF_8), problems);
  }

  @Test
  void rowsSayWhatNodesAreToSay() {
    EnrichmentScenes scene = EnrichmentScenes.with(NODES);
    scene.perform(
        edit(
                scene,
                """
                node,choice,field,value
                Switch_A,1,schemaBelonginess,Office
                Switch_A,1,schemaBelonginess,Lounge
                Switch_A,1,degreeOfConsistency,high
                Prox,,enterTimeSchemaActivation,Desk
                """)
            .orElseThrow());
    assertThat(problems.list()).isEmpty();
    assertThat(scene.switchNode("Switch_A").values().get(1))
        .isEqualTo(
            ChoiceMetadata.NONE.with(ConsistencyDegree.HIGH).with(List.of("Office", "Lounge")));
    assertThat(scene.sensor("Prox").schemas().enter()).containsExactly("Desk");
    assertThat(scene.document.history().undoName()).contains("Apply m.csv");
  }

  @Test
  void fieldsThatTheTableDoesNotNameStayAndAnEmptyValueClears() {
    EnrichmentScenes scene = EnrichmentScenes.with(NODES);
    scene.perform(
        edit(
                scene,
                """
                node;choice;field;value
                Switch_A;0;schemaBelonginess;Desk
                Switch_A;0;degreeOfConsistency;0,5
                """)
            .orElseThrow());
    scene.perform(
        edit(scene, "\ufeffNode, Choice, Field, Value\nSwitch_A,0,degreeOfConsistency,\n")
            .orElseThrow());
    assertThat(scene.switchNode("Switch_A").values().get(0))
        .isEqualTo(ChoiceMetadata.NONE.with(List.of("Desk")));
  }

  @Test
  void aRowThatCannotBeUnderstoodAppliesNothing() {
    EnrichmentScenes scene = EnrichmentScenes.with(NODES);
    Optional<Edit> edit =
        edit(
            scene,
            """
            node,choice,field,value
            Switch_A,0,schemaBelonginess,Desk
            Switch_B,0,schemaBelonginess,Desk
            Switch_A,2,schemaBelonginess,Desk
            Switch_A,0,belongs,Desk
            Switch_A,0,consistencyType,maybe
            Switch_A,0,degreeOfConsistency,2
            Prox,0,enterTimeSchema,Desk
            """);
    assertThat(edit).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            "m.csv:3:1: there is no Switch 'Switch_B' in the scene; is Switch_A meant?; the table"
                + " is not applied",
            "m.csv:4:10: Switch_A has choices 0 to 1, not '2'; the table is not applied",
            "m.csv:5:12: schema metadata has no field 'belongs'; the table is not applied",
            "m.csv:6:28: 'maybe' is unknown; write consistent, inconsistent or "
                + "frame; the table is not applied",
            "m.csv:7:32: '2' is not a degree; write low, high or a number from 0 to "
                + "1; the table is not applied",
            "m.csv:8:6: a ProximitySensor has no choices; leave the column choice empty; the table"
                + " is not applied");
  }

  @Test
  void aTableWithoutItsColumnsIsNone() {
    assertThat(edit(EnrichmentScenes.with(NODES), "a,b\n1,2\n")).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            "m.csv:1:1: the header lacks node, choice, field, value (it must be"
                + " node,choice,field,value); the table is not applied");
  }

  @Test
  void aTableMayBeOfASpreadsheetAndItsRowsShortOrLong() {
    EnrichmentScenes scene = EnrichmentScenes.with(NODES);
    byte[] table =
        "node\tchoice\tfield\tvalue\tfield\t\nSwitch_A\t0\t\tK\u00fcche\tschemaBelonginess\t\t\n"
            .getBytes(StandardCharsets.UTF_16);
    scene.perform(MetadataTable.edit(scene.enrichment, "m.txt", table, problems).orElseThrow());
    assertThat(scene.switchNode("Switch_A").values().get(0).schemas())
        .containsExactly("K\u00fcche");
    scene.perform(
        edit(scene, "node,choice,field,value\nSwitch_A,0,schemaBelonginess").orElseThrow());
    assertThat(scene.switchNode("Switch_A").values().get(0).schemas()).isEmpty();
    assertThat(problems.list()).isEmpty();
  }
}
