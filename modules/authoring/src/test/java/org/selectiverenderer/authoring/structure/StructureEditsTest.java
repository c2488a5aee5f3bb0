package org.selectiverenderer.authoring.structure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Nodes that are cut, pasted, moved and duplicated in a scene's text. */
class StructureEditsTest {
  private static final String SCENE =
      """
      <X3D version='4.0'>
        <Scene>
          <Transform DEF='Chair' translation='1 0 0'>
            <Shape DEF='Seat'>
              <Appearance DEF='Wood'/>
              <Box/>
            </Shape>
          </Transform>
          <Group DEF='Room'>
            <Shape DEF='Wall'>
              <Appearance USE='Wood'/>
            </Shape>
          </Group>
          <Group DEF='Empty'/> <!-- stays -->
          <TimeSensor DEF='Clock'/>
          <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Chair' toField='x'/>
        </Scene>
      </X3D>
      """;

  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private SceneDocument document = open(SCENE);

  private static SceneDocument open(String text) {
    try {
      return SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private StructureEdits edits() {
    return new StructureEdits(document, catalogue);
  }

  private DocumentElement named(String def) {
    return document.tree().orElseThrow().named(def).orElseThrow();
  }

  private DocumentElement scene() {
    return document.tree().orElseThrow().scene().orElseThrow();
  }

  private String text() {
    return document.snapshot().text();
  }

  /** Performs a change and returns what it says that it has added. */
  private List<String> perform(StructureChange change) {
    document.perform(change.edit());
    return change.elements(document).stream().map(DocumentElement::toString).toList();
  }

  private List<String> paste(String selected, String source) {
    return perform(edits().paste(Optional.of(named(selected)), source));
  }

  @Test
  void aNodeIsPastedIntoWhatTakesItAndElseBesideIt() {
    assertThat(paste("Empty", "<Shape>\n  <Sphere/>\n</Shape>")).containsExactly("Shape");
    assertThat(text())
        .contains(
            """
                <Group DEF='Empty'>
                  <Shape>
                    <Sphere/>
                  </Shape>
                </Group> <!-- stays -->
            """);
    assertThat(paste("Seat", "<Group/><Group/>")).containsExactly("Group", "Group");
    assertThat(text()).contains("      </Shape>\n      <Group/>\n      <Group/>\n    </Transform>");
    assertThat(paste("Wood", "<Material/>")).containsExactly("Material");
    assertThat(text()).contains("<Appearance DEF='Wood'>\n          <Material/>");
  }

  @Test
  void whatFitsNowhereSaysWhereItWouldGo() {
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Empty")), "<Material/>"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("neither into Group Empty nor beside it")
        .hasMessageContaining("Appearance Wood in line 5");
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Seat")), "<Sphere/>"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("only one node as its geometry");
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Empty")), "<TouchSensor/><Color/>"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("Color")
        .hasMessageContaining("insert a node that takes it first: ");
    for (String words : List.of("", "words", "<a><b></a>", "<X3D><Scene/></X3D>")) {
      assertThatThrownBy(() -> edits().paste(Optional.of(named("Empty")), words))
          .isInstanceOf(EditRejectedException.class)
          .hasMessageStartingWith("The clipboard holds no");
    }
    assertThat(text()).isEqualTo(SCENE);
  }

  @Test
  void aCopiedNodeIsPastedBehindItselfUnderTheNextFreeName() {
    String chair = edits().text(List.of(named("Chair")));
    assertThat(paste("Chair", chair)).containsExactly("Transform Chair_2");
    assertThat(paste("Chair_2", chair)).containsExactly("Transform Chair_3");
    assertThat(scene().children().stream().map(DocumentElement::toString).limit(3))
        .containsExactly("Transform Chair", "Transform Chair_2", "Transform Chair_3");
    assertThat(text()).contains("DEF='Wood_3'").doesNotContain("_2_2");
    document.history().undo();
    document.history().undo();
    assertThat(text()).isEqualTo(SCENE);
  }

  @Test
  void referencesWithinWhatIsPastedFollowAndOthersMustBeThere() {
    paste(
        "Empty",
        """
        <Transform DEF='Room'><Shape><Appearance DEF='Wood'/></Shape></Transform>
        <Transform DEF='T'><Shape><Appearance USE='Wood'/></Shape></Transform>
        <TimeSensor DEF='Clock'/>
        <ROUTE fromNode='Clock' fromField='time' toNode='Room' toField='y'/>
        """);
    assertThat(text())
        .contains("<Transform DEF='Room_2'>", "DEF='Wood_2'", "USE='Wood_2'")
        .contains("<ROUTE fromNode='Clock_2' fromField='time' toNode='Room_2' toField='y'/>");
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Empty")), "<Group USE='Nobody'/>"))
        .hasMessageContaining("Nobody");
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Seat")), "<Group USE='Empty'/>"))
        .hasMessageContaining("must be before it");
  }

  @Test
  void wholeFilesAndVrmlArePasted() {
    assertThat(
            paste(
                "Empty", "<?xml version='1.0'?><X3D><head/><Scene><Shape DEF='N'/></Scene></X3D>"))
        .containsExactly("Shape N");
    assertThat(paste("Empty", "DEF Pot Transform { children Shape { geometry Sphere {} } }"))
        .containsExactly("Transform Pot");
    assertThat(paste("Empty", "#VRML V2.0 utf8\nGroup { } Group { }"))
        .containsExactly("Group", "Group");
    assertThat(text()).contains("<Sphere/>");
    assertThatThrownBy(() -> edits().paste(Optional.of(named("Empty")), "Shape { geometry [ "))
        .isInstanceOf(EditRejectedException.class);
  }

  @Test
  void theFieldThatTakesANodeIsWrittenWhereItIsNotTheUsualOne() {
    document = open("<X3D><Scene><Collision DEF='C'/><Group DEF='G'/></Scene></X3D>");
    paste("G", "<Shape containerField='proxy'/>");
    assertThat(text()).contains("<Shape containerField='children'/>");
    paste("C", "<Shape containerField='proxy'/>");
    assertThat(text()).contains("<Collision DEF='C'><Shape containerField='proxy'/></Collision>");
  }

  @Test
  void severalNodesAreRemovedWithTheirRoutesAndUsesAmongThem() {
    document.perform(edits().remove(List.of(named("Chair"), named("Room"), named("Seat")), "Cut"));
    assertThat(text())
        .isEqualTo(
            """
            <X3D version='4.0'>
              <Scene>
                <Group DEF='Empty'/> <!-- stays -->
                <TimeSensor DEF='Clock'/>
              </Scene>
            </X3D>
            """);
    assertThat(document.history().undoName()).contains("Cut 2 nodes");
    document.history().undo();
    assertThatThrownBy(() -> edits().remove(List.of(named("Chair")), "Cut"))
        .hasMessageContaining("Wood is used elsewhere (USE in line 11)");
    assertThatThrownBy(() -> edits().remove(List.of(scene()), "Cut")).hasMessageContaining("Scene");
  }

  @Test
  void nodesMoveBetweenParentsAndKeepTheirNamesAndRoutes() {
    assertThat(perform(edits().move(List.of(named("Wall")), ChildPosition.last(named("Empty")))))
        .containsExactly("Shape Wall");
    assertThat(text())
        .contains(
            """
                <Group DEF='Empty'>
                  <Shape DEF='Wall'>
                    <Appearance USE='Wood'/>
                  </Shape>
                </Group> <!-- stays -->
            """);
    perform(edits().move(List.of(named("Clock")), new ChildPosition(scene(), 0)));
    assertThat(scene().children().get(0)).hasToString("TimeSensor Clock");
    assertThat(text()).contains("<ROUTE fromNode='Clock'");
    document.history().undo();
    document.history().undo();
    assertThat(text()).isEqualTo(SCENE);
  }

  @Test
  void aMoveThatWouldBreakTheSceneIsRefused() {
    assertThatThrownBy(() -> edits().move(List.of(named("Room")), new ChildPosition(scene(), 0)))
        .hasMessageContaining("It uses Wood (USE), which must be before it");
    assertThatThrownBy(
            () -> edits().move(List.of(named("Chair")), ChildPosition.last(named("Empty"))))
        .hasMessageContaining("Wood is used in line 11 (USE) and must stay before that");
    assertThatThrownBy(
            () -> edits().move(List.of(named("Room")), ChildPosition.last(named("Room"))))
        .hasMessageContaining("into itself");
    assertThatThrownBy(
            () -> edits().move(List.of(named("Wood")), ChildPosition.last(named("Empty"))))
        .hasMessageContaining("Appearance Wood cannot go into Group Empty");
    assertThatThrownBy(() -> edits().move(List.of(scene()), ChildPosition.last(named("Empty"))))
        .isInstanceOf(EditRejectedException.class);
    document =
        open(
            "<X3D><Scene><Group DEF='G'/><ProtoDeclare name='P'><ProtoBody><Group DEF='G'/>"
                + "<Shape DEF='S'/></ProtoBody></ProtoDeclare></Scene></X3D>");
    DocumentElement body = scene().children().get(1).children().get(0);
    assertThatThrownBy(
            () -> edits().move(List.of(body.children().get(1)), ChildPosition.last(scene())))
        .hasMessageContaining("names of its own");
  }

  @Test
  void aPrototypeStaysBeforeItsInstances() {
    document =
        open(
            "<X3D><Scene><Group DEF='G'/><ProtoDeclare name='P'><ProtoBody><Shape/></ProtoBody>"
                + "</ProtoDeclare><ProtoInstance DEF='I' name='P'/></Scene></X3D>");
    DocumentElement declaration = scene().children().get(1);
    assertThatThrownBy(() -> edits().move(List.of(named("I")), new ChildPosition(scene(), 0)))
        .hasMessageContaining("prototype P")
        .hasMessageContaining("must be before");
    assertThatThrownBy(() -> edits().move(List.of(declaration), ChildPosition.last(scene())))
        .hasMessageContaining("must stay before its instance in line 1");
    perform(edits().move(List.of(declaration, named("I")), new ChildPosition(scene(), 0)));
    assertThat(scene().children())
        .extracting(DocumentElement::name)
        .containsExactly("ProtoDeclare", "ProtoInstance", "Group");
  }

  @Test
  void siblingsMoveUpAndDownByOnePlace() {
    assertThat(perform(edits().step(List.of(named("Clock")), false)))
        .containsExactly("TimeSensor Clock");
    assertThat(names()).containsExactly("Chair", "Room", "Clock", "Empty", "");
    perform(edits().step(List.of(named("Room"), named("Clock")), true));
    assertThat(names()).containsExactly("Chair", "Empty", "Room", "Clock", "");
    assertThatThrownBy(() -> edits().step(List.of(named("Chair")), false))
        .hasMessageContaining("the first one already");
    assertThatThrownBy(() -> edits().step(List.of(scene().children().get(4)), true))
        .hasMessageContaining("the last one already");
    assertThatThrownBy(() -> edits().step(List.of(named("Chair"), named("Wall")), true))
        .hasMessageContaining("one parent");
  }

  private List<String> names() {
    return scene().children().stream().map(each -> each.def().orElse("")).toList();
  }

  @Test
  void duplicatesLieBesideTheirOriginalsUnderTheNextFreeNames() {
    Function<DocumentElement, Vector3d> half = node -> new Vector3d(0.5, 0, 0);
    assertThat(perform(edits().duplicate(List.of(named("Chair")), half)))
        .containsExactly("Transform Chair_2");
    assertThat(perform(edits().duplicate(List.of(named("Chair_2")), half)))
        .containsExactly("Transform Chair_3");
    assertThat(text())
        .contains("<Transform DEF='Chair_2' translation='1.5 0 0'>")
        .contains("<Transform DEF='Chair_3' translation='2 0 0'>");
    assertThat(perform(edits().duplicate(List.of(named("Room"), named("Empty")), half)))
        .containsExactly("Transform", "Transform");
    assertThat(text())
        .contains(
            """
                <Transform translation='0.5 0 0'>
                  <Group DEF='Room_2'>
                    <Shape DEF='Wall_2'>
                      <Appearance USE='Wood'/>
                    </Shape>
                  </Group>
                </Transform>
            """);
    for (int i = 0; i < 3; i++) {
      document.history().undo();
    }
    assertThat(text()).isEqualTo(SCENE);
    assertThatThrownBy(() -> edits().duplicate(List.of(named("Wood")), half))
        .hasMessageContaining("only one node as its appearance");
  }

  @Test
  void instancesOfPrototypesGoWhereTheFirstNodeOfTheirBodyMay() {
    document =
        open(
            """
            <X3D><Scene><ProtoDeclare name='Paint'><ProtoBody><Material/></ProtoBody></ProtoDeclare>
            <Shape DEF='S'><Appearance DEF='A'/></Shape><Group DEF='G'/>
            <ProtoInstance name='Unknown' DEF='U'/></Scene></X3D>
            """);
    String paint = "<ProtoInstance name='Paint' containerField='material'/>";
    assertThat(new Containment(catalogue).accepts(named("G"), named("U"))).isTrue();
    assertThatThrownBy(
            () -> edits().paste(Optional.of(named("G")), "<ProtoInstance name='X'/><Box/>"))
        .hasMessageContaining("Box");
    paste("G", "<Shape/>");
    document.perform(edits().paste(Optional.of(named("A")), paint).edit());
    assertThat(text()).contains("<Appearance DEF='A'>" + paint + "</Appearance>");
  }

  @Test
  void theMetadataOfACopiedAreaIsCalledAfterTheCopy() {
    document =
        open(
            """
            <X3D><Scene>
              <ProximitySensor DEF='Desk' size='2 3 2'>
                <MetadataSet DEF='MetadataSet_DeskDefinition' name='Desk'>
                  <MetadataString DEF='enterTimeSchemaDefinitionDesk' name='enterTimeSchema' value='"A"'/>
                </MetadataSet>
              </ProximitySensor>
            </Scene></X3D>
            """);
    perform(edits().duplicate(List.of(named("Desk")), node -> new Vector3d(2, 0, 0)));
    assertThat(text())
        .contains(
            """
              <ProximitySensor DEF='Desk_2' size='2 3 2' center='2 0 0'>
                <MetadataSet DEF='MetadataSet_Desk_2Definition' name='Desk_2'>
                  <MetadataString DEF='enterTimeSchemaDefinitionDesk_2' name='enterTimeSchema' value='"A"'/>
            """);
  }

  @Test
  void choicesWithMetadataKeepTheirOrder() {
    document =
        open(
            """
            <X3D><Scene><Group DEF='G'/><Switch DEF='Switch_Cup' whichChoice='0'>
            <MetadataSet containerField='metadata' name='Cup'>
            <MetadataSet containerField='value' name='Cup_v1'>
            <MetadataString containerField='value' name='consistencyType' value='"consistent"'/>
            </MetadataSet></MetadataSet>
            <Group DEF='One'/><Group DEF='Two'/></Switch></Scene></X3D>
            """);
    String before = text();
    for (StructureMove move :
        List.<StructureMove>of(
            () -> edits().move(List.of(named("One")), ChildPosition.last(named("G"))).edit(),
            () -> edits().move(List.of(named("G")), ChildPosition.after(named("One"))).edit(),
            () -> edits().duplicate(List.of(named("One")), node -> new Vector3d()).edit(),
            () -> edits().remove(List.of(named("One"), named("Two")), "Delete"))) {
      assertThatThrownBy(move::edit)
          .isInstanceOf(EditRejectedException.class)
          .hasMessageContaining("The choices of Switch_Cup have metadata in their order");
    }
    assertThat(text()).isEqualTo(before);
    perform(edits().copy(List.of(named("G")), ChildPosition.last(named("Switch_Cup"))));
    assertThat(text()).contains("<Group DEF='Two'/><Group DEF='G_2'/></Switch>");
  }

  @Test
  void aPrototypeIsCutOnlyTogetherWithItsInstances() {
    document =
        open(
            """
            <X3D><Scene><ProtoDeclare name='P'><ProtoBody><Group/></ProtoBody></ProtoDeclare>
            <ProtoInstance name='P' DEF='I'/><Group DEF='G'/></Scene></X3D>
            """);
    DocumentElement declaration = scene().children().get(0);
    assertThatThrownBy(() -> edits().remove(List.of(declaration, named("G")), "Cut"))
        .hasMessageContaining("the prototype P has an instance in line 2");
    document.perform(edits().remove(List.of(declaration, named("I")), "Cut"));
    assertThat(scene().children()).hasToString("[Group G]");
  }

  private interface StructureMove {
    Edit edit();
  }
}
