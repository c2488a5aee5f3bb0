package org.selectiverenderer.authoring.nodes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.editing.CodeCompletion;
import org.selectiverenderer.authoring.editing.CompletionProposal;
import org.selectiverenderer.authoring.editing.FieldEdits;
import org.selectiverenderer.authoring.editing.NodeField;
import org.selectiverenderer.authoring.editing.NodeFieldList;
import org.selectiverenderer.authoring.structure.StructureEdits;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** DEF names of a prototype's declaration mean nothing in the scene, and the other way round. */
class PrototypeScopeTest {
  private static final String SCENE =
      """
      <X3D><Scene>
        <ProtoDeclare name='Chair'>
          <ProtoInterface>
            <field name='seat' type='SFNode' accessType='inputOutput'><Shape DEF='Seat'/></field>
          </ProtoInterface>
          <ProtoBody>
            <ProtoDeclare name='Leg'><ProtoBody>
              <Group DEF='Inner'/>
            </ProtoBody></ProtoDeclare>
            <Group DEF='Box'><Group USE='Seat'/></Group>
            <Group USE='Box'/>
            <TimeSensor DEF='Clock'/>
            <ROUTE fromNode='Clock' fromField='time' toNode='Box' toField='x'/>
          </ProtoBody>
        </ProtoDeclare>
        <Group DEF='Box'/>
        <Group USE='Box'/>
        <Transform DEF='Lone'/>
        <ProtoInstance name='Chair' DEF='Chair1'/>
      </Scene></X3D>
      """;

  private final SceneDocument document;
  private final NodeEdits edits;

  PrototypeScopeTest() throws IOException {
    document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    edits = new NodeEdits(document);
  }

  private ElementTree tree() {
    return document.tree().orElseThrow();
  }

  private DocumentElement at(String text) {
    return tree().at(document.text().toString().indexOf(text)).orElseThrow();
  }

  private DocumentElement outer() {
    return at("<Group DEF='Box'/>");
  }

  private DocumentElement inner() {
    return at("<Group DEF='Box'><");
  }

  @Test
  void aNameMeansTheNodeOfItsOwnScope() {
    assertThat(tree().named("Box")).contains(outer());
    assertThat(tree().named("Box", outer())).contains(outer());
    assertThat(tree().named("Box", inner())).contains(inner());
    assertThat(tree().named("Inner")).isEmpty();
    assertThat(tree().named("Inner", inner())).isEmpty();
    assertThat(tree().named("Seat", inner())).contains(at("<Shape DEF='Seat'/>"));
    assertThat(tree().named("Box", at("<Group DEF='Inner'/>"))).isEmpty();
    assertThat(tree().used("Seat")).isFalse();
    assertThat(tree().used("Seat", inner())).isTrue();
  }

  @Test
  void theScopesFollowEdits() {
    document.perform(edits.rename(inner(), "Case"));
    assertThat(tree().named("Case", at("<Group DEF='Case'>"))).isPresent();
    assertThat(tree().named("Case")).isEmpty();
    document.history().undo();
    DocumentElement declaration = at("<ProtoDeclare name='Leg'>");
    document.perform(new Edit("", List.of(document.layout().remove(declaration))));
    assertThat(tree().named("Box")).contains(outer());
    assertThat(tree().named("Box", inner())).contains(inner());
  }

  @Test
  void aNodeIsRenamedInItsOwnScopeOnly() {
    document.perform(edits.rename(outer(), "Seat")); // a name of the prototype is free outside
    assertThat(document.text())
        .hasToString(
            SCENE.replace(
                "<Group DEF='Box'/>\n  <Group USE='Box'/>",
                "<Group DEF='Seat'/>\n  <Group USE='Seat'/>"));
    document.history().undo();
    document.perform(edits.rename(inner(), "Lone"));
    assertThat(document.text())
        .hasToString(
            SCENE
                .replace("<Group DEF='Box'><", "<Group DEF='Lone'><")
                .replace(
                    "    <Group USE='Box'/>\n      <TimeSensor",
                    "    <Group USE='Lone'/>\n      <TimeSensor")
                .replace("toNode='Box'", "toNode='Lone'"));
    assertThatThrownBy(() -> edits.rename(at("<Group DEF='Lone'>"), "Seat"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("Seat is the name of the Shape");
  }

  @Test
  void deletingLooksForReferencesInTheNodesOwnScope() {
    DocumentElement use = at("<Group USE='Box'/>\n  <Transform");
    document.perform(edits.remove(use));
    document.perform(edits.remove(outer())); // the USE in the prototype means another node
    assertThat(document.text())
        .hasToString(SCENE.replace("  <Group DEF='Box'/>\n  <Group USE='Box'/>\n", ""));
    assertThatThrownBy(() -> edits.remove(inner())).isInstanceOf(EditRejectedException.class);
  }

  @Test
  void aPrototypeThatHasInstancesIsNotDeleted() {
    assertThatThrownBy(() -> edits.remove(at("<ProtoDeclare name='Chair'>")))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("line 19");
    document.perform(edits.remove(at("<ProtoInstance")));
    document.perform(edits.remove(at("<ProtoDeclare name='Chair'>")));
    assertThat(document.text())
        .hasToString(
            """
        <X3D><Scene>
          <Group DEF='Box'/>
          <Group USE='Box'/>
          <Transform DEF='Lone'/>
        </Scene></X3D>
        """);
  }

  @Test
  void copiesGetNamesThatAreFreeInTheirScope() {
    document.perform(edits.copy(inner(), edits.free("Inner", inner())));
    assertThat(document.text()).contains("<Group DEF='Inner'><Group USE='Seat'/></Group>");
    document.history().undo();
    assertThat(edits.free("Inner")).isEqualTo("Inner");
    assertThat(edits.free("Box", inner())).isEqualTo("Box_2");
    assertThat(new UniqueNameGenerator(tree(), inner()).unused("Lone")).isEqualTo("Lone");
    DocumentElement group = at("<Group DEF='Box'/>");
    document.perform(
        new StructureEdits(document, NodeCatalogue.load())
            .paste(Optional.of(group), "<Group DEF='Clock'><Group DEF='Box'/></Group>")
            .edit());
    assertThat(document.text()).contains("<Group DEF='Clock'><Group DEF='Box_2'/></Group>");
  }

  @Test
  void aCopyKeepsTheNamesOfThePrototypesInIt() {
    document.perform(
        new Edit(
            "",
            List.of(
                document
                    .layout()
                    .insertLast(
                        tree().scene().orElseThrow(),
                        List.of(
                            "<Group DEF='Both'><ProtoDeclare name='P'><ProtoBody><Group DEF='Both'/>"
                                + "</ProtoBody></ProtoDeclare></Group>")))));
    document.perform(edits.copy(tree().named("Both").orElseThrow(), "Other"));
    assertThat(document.text())
        .contains(
            "<Group DEF='Other'><ProtoDeclare name='P'><ProtoBody><Group DEF='Both'/></ProtoBody>");
  }

  @Test
  void aUseOffersTheNamesOfItsScope() {
    assertThat(uses("<Group USE='Box'/>\n  <Transform")).containsExactly("Box");
    assertThat(uses("<Group USE='Box'/>\n      <Time")).containsExactly("Box");
    DocumentElement use = at("<Group USE='Box'/>\n  <Transform");
    NodeField field =
        NodeFieldList.of(document, NodeCatalogue.load(), use).stream()
            .filter(each -> each.name().equals("USE"))
            .findFirst()
            .orElseThrow();
    assertThat(new FieldEdits(document).wrong(use, field, "Inner")).isPresent();
  }

  private List<String> uses(String text) {
    return NodeFieldList.of(document, NodeCatalogue.load(), at(text)).stream()
        .filter(each -> each.name().equals("USE"))
        .findFirst()
        .orElseThrow()
        .choices();
  }

  @Test
  void completionProposesTheNamesOfTheScopeOfTheCaret() {
    String text = SCENE.replace("<Transform DEF='Lone'/>", "<Transform DEF='Lone'/><Group USE='");
    assertThat(words(text, text.indexOf("<Group USE='\n") + 12)).containsExactly("Box");
    String route = SCENE.replace("</Scene></X3D>\n", "<ROUTE fromNode='");
    assertThat(words(route, route.length())).containsExactly("Box", "Lone", "Chair1");
    String body = SCENE.replace("<ROUTE fromNode='Clock'", "<ROUTE fromNode='");
    assertThat(words(body, body.indexOf("<ROUTE fromNode='") + 17))
        .containsExactly("Seat", "Box", "Clock");
  }

  private static List<String> words(String text, int caret) {
    return CodeCompletion.at(text, caret, NodeCatalogue.load()).proposals().stream()
        .map(CompletionProposal::word)
        .toList();
  }
}
