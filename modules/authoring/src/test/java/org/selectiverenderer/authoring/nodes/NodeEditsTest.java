package org.selectiverenderer.authoring.nodes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.x3d.source.DocumentElement;

class NodeEditsTest {
  private static final String NODES =
      """
        <Inline DEF='Model' url='"m.x3d"'/>
        <IMPORT inlineDEF='Model' importedDEF='Clock'/>
        <Transform DEF='Box' >
          <!-- kept -->
          <Shape  DEF="Look"><Box/></Shape>
        </Transform>
        <Transform translation='1 0 0'>
          <Transform USE='Box'/>
        </Transform>
        <TimeSensor DEF='T'/>
        <ROUTE fromNode='T' fromField='cycleTime' toNode='Box' toField='translation'/>
        <ROUTE fromNode='T' fromField='time' toNode='T' toField='startTime'/>
        <EXPORT localDEF='Box'/>
      """;

  private final EnrichmentScenes scene = EnrichmentScenes.with(NODES);
  private final NodeEdits edits = new NodeEdits(scene.document);

  private DocumentElement named(String def) {
    return scene.document.tree().orElseThrow().named(def).orElseThrow();
  }

  private void undone(String before) {
    assertThat(scene.document.history().names()).hasSize(1);
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(before);
  }

  @Test
  void aNewNameIsSaidByAllThatSpeakOfTheNodeAndOtherFilesGoOnKnowingTheOldOne() {
    Edit edit = edits.rename(named("Box"), "Crate");
    scene.perform(edit);
    assertThat(edit.name()).isEqualTo("Rename Box to Crate");
    assertThat(scene.nodes())
        .isEqualTo(
            NODES
                .replace("DEF='Box'", "DEF='Crate'")
                .replace("USE='Box'", "USE='Crate'")
                .replace("toNode='Box'", "toNode='Crate'")
                .replace("localDEF='Crate'/>", "localDEF='Crate' AS='Box'/>"));
    undone(NODES);
    scene.perform(edits.rename(named("Model"), "Lamp"));
    assertThat(scene.nodes()).isEqualTo(NODES.replace("'Model'", "'Lamp'"));
  }

  @Test
  void whatEveryScenesHasAndWhatStandsForOthersIsLeftAlone() {
    DocumentElement sceneElement = named("Box").parent().orElseThrow();
    assertThatThrownBy(() -> edits.remove(sceneElement)).isInstanceOf(EditRejectedException.class);
    assertThatThrownBy(() -> edits.copy(sceneElement, "Other"))
        .isInstanceOf(EditRejectedException.class);
    DocumentElement use = sceneElement.children().get(3).children().get(0);
    assertThatThrownBy(() -> edits.rename(use, "Other"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("rename the original");
  }

  @Test
  void namesOfPrototypesAreOthers() {
    EnrichmentScenes with =
        EnrichmentScenes.with(
            """
            <ProtoDeclare name='P'><ProtoBody><Group DEF='A'/><Group USE='A'/></ProtoBody></ProtoDeclare>
            <Group DEF='B'/>
            """);
    NodeEdits inner = new NodeEdits(with.document);
    DocumentElement body =
        with.document
            .tree()
            .orElseThrow()
            .prototype("P", with.document.tree().orElseThrow().named("B").orElseThrow())
            .orElseThrow();
    with.perform(inner.rename(body.children().get(0).children().get(0), "C"));
    assertThat(with.nodes()).contains("DEF='C'/><Group USE='C'/>");
  }

  @Test
  void aNameThatIsNoneOrTakenIsRefusedWithWhatToDo() {
    assertThatThrownBy(() -> edits.rename(named("Box"), "my box"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("'my box' is not a valid DEF name")
        .hasMessageEndingWith("such as my_box");
    assertThatThrownBy(() -> edits.rename(named("Box"), "T"))
        .hasMessageContaining("TimeSensor in line 12 already");
    assertThat(edits.rename(named("Box"), " Box ").isEmpty()).isTrue();
  }

  @Test
  void aCopyHasNewNamesAndKeepsItsLayout() {
    scene.perform(edits.copy(named("Box"), "Box_2"));
    assertThat(scene.nodes())
        .contains(
            """
              </Transform>
              <Transform DEF='Box_2' >
                <!-- kept -->
                <Shape  DEF="Look_2"><Box/></Shape>
              </Transform>
              <Transform translation='1 0 0'>
            """
                .indent(0));
    undone(NODES);
  }

  @Test
  void whatIsTakenOutTakesItsRoutesAlongAndIsKeptWhileSomethingStandsForIt() {
    assertThatThrownBy(() -> edits.remove(named("Box")))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("USE in line 10");
    scene.perform(edits.remove(named("T")));
    assertThat(scene.nodes()).doesNotContain("ROUTE").doesNotContain("TimeSensor");
    assertThat(scene.nodes()).contains("</Transform>\n  <EXPORT localDEF='Box'/>");
    undone(NODES);
  }

  @Test
  void groupsThatHoldNothingElseGoToo() {
    String nodes =
        """
        <Group/>
        <Transform DEF='a'>
          <Transform translation='0 1 0'>
            <ProximitySensor DEF='P' size='1 1 1'/>
          </Transform>
        </Transform>
        <Transform>
          <!-- of the author -->
          <ProximitySensor DEF='Q' size='1 1 1'/>
        </Transform>
        """;
    EnrichmentScenes with = EnrichmentScenes.with(nodes);
    NodeEdits of = new NodeEdits(with.document);
    with.perform(of.remove(with.sensor("P").element()));
    assertThat(with.nodes()).startsWith("<Group/>\n<Transform>\n  <!-- of").contains("DEF='Q'");
    with.perform(of.remove(with.sensor("Q").element()));
    assertThat(with.nodes())
        .isEqualTo("<Group/>\n<Transform>\n  <!-- of the author -->\n</Transform>\n");
  }
}
