package org.selectiverenderer.authoring.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

class PlacementEditsTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  private static DocumentElement named(EnrichmentScenes scene, String def) {
    return scene.document.tree().orElseThrow().named(def).orElseThrow();
  }

  private static Placement placement(EnrichmentScenes scene, String def) {
    return Placement.of(scene.document, CATALOGUE, named(scene, def)).orElseThrow();
  }

  private static void place(EnrichmentScenes scene, Placement placed) {
    scene.perform(new PlacementEdits(scene.document).place(List.of(placed), "Move"));
  }

  /** Returns where a point of a node is in the scene. */
  private static Vector3d at(EnrichmentScenes scene, String def, double x, double y, double z) {
    Matrix4d world =
        new Matrix4d(LocalCoordinateSystem.of(named(scene, def)).orElseThrow().world());
    return world.transformPosition(new Vector3d(x, y, z));
  }

  private static void near(Vector3d is, Vector3d wanted) {
    assertThat(is.distance(wanted)).as("%s, not %s", is, wanted).isCloseTo(0, within(2e-3));
  }

  @Test
  void onlyTheNumbersThatChangeAreWritten() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "  <Transform DEF='T'   translation='1.50 2e0 3' rotation = '0 1 0 .5'><Shape"
                + " DEF='S'/></Transform> <!-- a chair -->\n");
    Placement of = placement(scene, "T");
    place(scene, of.with(of.pose().movedBy(new Vector3d(0.1 + 1e-9, 0, -0.25))));
    assertThat(scene.nodes())
        .isEqualTo(
            "  <Transform DEF='T'   translation='1.6 2 2.75' rotation = '0 1 0 .5'><Shape"
                + " DEF='S'/></Transform> <!-- a chair -->\n");
    of = placement(scene, "T");
    Quaterniond turn = new Quaterniond().rotateY(Math.toRadians(15));
    place(scene, of.with(of.pose().turned(turn, new Vector3d(1.6, 0, 2.75))));
    assertThat(scene.nodes()).contains("translation='1.6 2 2.75' rotation = '0 1 0 0.761799'");
    place(scene, placement(scene, "T"));
    assertThat(scene.document.history().names()).hasSize(2);
  }

  @Test
  void aNodeWithoutATransformGetsOneAndOneThatIsAloneInItsTransformIsMovedByIt() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
              <Group>
                <Shape DEF='S'>
                  <Box/>
                </Shape>
              </Group>
              <Transform DEF='T' translation='0 0 1'><Inline DEF='I' url='"a.x3d"'/></Transform>
            """);
    Placement of = placement(scene, "S");
    assertThat(of.transform()).isEmpty();
    place(scene, of.with(of.pose().movedBy(new Vector3d(0.5, 0, 0))));
    assertThat(scene.nodes())
        .contains(
            """
                <Transform translation='0.5 0 0'>
                  <Shape DEF='S'>
                    <Box/>
                  </Shape>
                </Transform>
            """);
    assertThat(placement(scene, "I").transform()).containsSame(named(scene, "T"));
    scene.document.history().undo();
    assertThat(scene.nodes()).contains("    <Shape DEF='S'>\n      <Box/>\n    </Shape>\n");
  }

  @Test
  void aTransformThatIsUsedElsewhereStaysAndItsNodeGetsOneOfItsOwn() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Transform DEF='T'><Shape DEF='S'/></Transform><Transform USE='T'/>\n");
    assertThat(placement(scene, "S").transform()).isEmpty();
    DocumentElement use =
        scene.document.tree().orElseThrow().scene().orElseThrow().children().get(1);
    Placement of = Placement.of(scene.document, CATALOGUE, use).orElseThrow();
    place(scene, of.with(of.pose().movedBy(new Vector3d(0, 0, 2))));
    assertThat(scene.nodes())
        .isEqualTo(
            "<Transform DEF='T'><Shape DEF='S'/></Transform>"
                + "<Transform translation='0 0 2'><Transform USE='T'/></Transform>\n");
  }

  @Test
  void whatDoesNotStandInTheSceneByItselfHasNoPlacement() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <ProtoDeclare name='P'><ProtoBody><Transform DEF='In'/></ProtoBody></ProtoDeclare>
            <Transform scale='0 1 1'><Transform DEF='Flat'/></Transform>
            <Billboard><Transform DEF='Turning'/></Billboard>
            <Shape><Appearance DEF='A'/></Shape>
            <Viewpoint DEF='V'/>
            """);
    for (String name : List.of("A", "V", "Flat", "Turning")) {
      assertThat(Placement.of(scene.document, CATALOGUE, named(scene, name))).as(name).isEmpty();
    }
    DocumentElement scenes = scene.document.tree().orElseThrow().scene().orElseThrow();
    DocumentElement body = scenes.children().get(0).children().get(0).children().get(0);
    assertThat(Placement.of(scene.document, CATALOGUE, body)).isEmpty();
  }

  @Test
  void aShiftInTheSceneIsTheSameUnderTurnedAndScaledParents() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform translation='3 1 0' rotation='1 2 0 0.7' scale='2 0.5 10' scaleOrientation='0 0 1 0.3'>
              <Transform center='1 0 0' rotation='0 0 0 2' scale='1 1 0.01'>
                <Transform DEF='T' translation='1 1 1' center='0 2 0' rotation='0 1 0 1'>
                  <Shape DEF='S'/><Shape/>
                </Transform>
              </Transform>
            </Transform>
            """);
    Vector3d before = at(scene, "S", 1, 2, 3);
    Placement of = placement(scene, "T");
    Vector3d shift = new Vector3d(0.5, -0.25, 2);
    Vector3d own = of.parent().invert(new Matrix4d()).transformDirection(new Vector3d(shift));
    place(scene, of.with(of.pose().movedBy(own)));
    near(at(scene, "S", 1, 2, 3), before.add(shift));
    assertThat(scene.nodes()).doesNotContain("NaN");
  }

  @Test
  void turningAndScalingKeepTheirFixedPoint() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform DEF='T' translation='1 1 1' center='0 2 0' rotation='0 1 0 1' scale='1 2 -3'
                scaleOrientation='1 0 0 0.4'><Shape DEF='S'/><Shape/></Transform>
            """);
    Vector3d pivot = at(scene, "S", 0.5, -1, 0.25);
    Vector3d other = at(scene, "S", 1, 1, 1);
    Placement of = placement(scene, "T");
    Quaterniond turn = new Quaterniond().rotateX(0.4).rotateY(2);
    place(scene, of.with(of.pose().turned(turn, pivot)));
    near(at(scene, "S", 0.5, -1, 0.25), pivot);
    near(at(scene, "S", 1, 1, 1), turn.transform(other.sub(pivot)).add(pivot));
    of = placement(scene, "T");
    place(scene, of.with(of.pose().scaled(new Vector3d(2, 0.5, 3), new Vector3d(0.5, -1, 0.25))));
    near(at(scene, "S", 0.5, -1, 0.25), pivot);
    assertThat(scene.nodes()).contains("scale='2 1 -9'");
  }

  @Test
  void everyMatrixWithoutAShadowIsAPose() {
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      double[] m = random.doubles(12, -2, 2).toArray();
      Matrix4d matrix =
          new Matrix4d(
              m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0, m[9], m[10], m[11], 1);
      TransformPose pose = TransformPose.of(matrix, new Vector3d(1, -2, 0.5));
      assertThat(pose.matrix().equals(matrix, 1e-6)).as("%s", matrix).isTrue();
    }
    TransformPose plain =
        TransformPose.of(new Matrix4d().rotateY(1).scale(1, 2, 3), new Vector3d());
    assertThat(plain.scale().distance(1, 2, 3)).isCloseTo(0, within(1e-9));
    assertThat(plain.scaleOrientation().angle()).isCloseTo(0, within(1e-9));
  }

  @Test
  void boxesAreAlignedAndDistributed() {
    List<BoundingBox> boxes =
        List.of(
            new BoundingBox(0, 0, 0, 1, 1, 1),
            new BoundingBox(8, 2, 0, 10, 3, 1),
            new BoundingBox(2, 1, 0, 3, 5, 1));
    assertThat(Arrangement.align(boxes, 0, Arrangement.Side.LOWER))
        .containsExactly(new Vector3d(), new Vector3d(-8, 0, 0), new Vector3d(-2, 0, 0));
    assertThat(Arrangement.align(boxes, 1, Arrangement.Side.MIDDLE))
        .containsExactly(new Vector3d(0, 2, 0), new Vector3d(), new Vector3d(0, -0.5, 0));
    assertThat(Arrangement.align(boxes, 1, Arrangement.Side.UPPER))
        .containsExactly(new Vector3d(0, 4, 0), new Vector3d(0, 2, 0), new Vector3d());
    assertThat(Arrangement.distribute(boxes, 0))
        .containsExactly(new Vector3d(), new Vector3d(), new Vector3d(2, 0, 0));
  }

  private static GroupEdits groups(EnrichmentScenes scene) {
    return new GroupEdits(scene.document, CATALOGUE);
  }

  @Test
  void siblingsAreGroupedAndUngroupedAgain() {
    String nodes =
        """
          <Shape DEF='A'/>
          <Viewpoint/>
          <Group DEF='B'>
            <Shape USE='A'/>
          </Group>
          <Shape DEF='C'/>
        """;
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    List<DocumentElement> two = List.of(named(scene, "B"), named(scene, "A"));
    scene.perform(groups(scene).group(two, "Pair"));
    assertThat(scene.nodes())
        .isEqualTo(
            """
              <Transform DEF='Pair'>
                <Shape DEF='A'/>
                <Group DEF='B'>
                  <Shape USE='A'/>
                </Group>
              </Transform>
              <Viewpoint/>
              <Shape DEF='C'/>
            """);
    scene.perform(groups(scene).ungroup(named(scene, "Pair")));
    assertThat(scene.nodes())
        .isEqualTo(
            """
              <Shape DEF='A'/>
              <Group DEF='B'>
                <Shape USE='A'/>
              </Group>
              <Viewpoint/>
              <Shape DEF='C'/>
            """);
    assertThat(scene.document.history().names()).containsExactly("Group 2 nodes", "Ungroup Pair");
  }

  @Test
  void aDefStaysBeforeItsUsesWhenNodesAreGrouped() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Shape DEF='A'/><Shape DEF='B'/><Group DEF='C'><Shape USE='B'/></Group>\n");
    scene.perform(groups(scene).group(List.of(named(scene, "A"), named(scene, "C")), "G"));
    assertThat(scene.nodes())
        .isEqualTo(
            "<Shape DEF='B'/><Transform DEF='G'><Shape DEF='A'/><Group DEF='C'><Shape USE='B'/>"
                + "</Group></Transform>\n");
  }

  @Test
  void aDeclarationStaysBeforeItsInstanceWhenNodesAreGrouped() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Shape DEF='A'/><ProtoDeclare name='P'><ProtoBody><Shape/></ProtoBody></ProtoDeclare>"
                + "<ProtoInstance DEF='C' name='P'/>");
    scene.perform(groups(scene).group(List.of(named(scene, "A"), named(scene, "C")), "G"));
    assertThat(scene.nodes())
        .isEqualToIgnoringWhitespace(
            "<ProtoDeclare name='P'><ProtoBody><Shape/></ProtoBody></ProtoDeclare>"
                + "<Transform DEF='G'><Shape DEF='A'/><ProtoInstance DEF='C' name='P'/></Transform>");
  }

  @Test
  void aGroupInAPrototypeIsNamedInItsScope() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Shape DEF='Outside'/><ProtoDeclare name='P'><ProtoBody><Group DEF='Inside'><Shape/>"
                + "</Group></ProtoBody></ProtoDeclare>");
    List<DocumentElement> shape = new ArrayList<>();
    scene
        .document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            each -> {
              if (each.name().equals("Shape") && each.def().isEmpty()) {
                shape.add(each);
              }
            });
    assertThatThrownBy(() -> groups(scene).group(shape, "Inside"))
        .isInstanceOf(EditRejectedException.class);
    scene.perform(groups(scene).group(shape, "Outside"));
    assertThat(scene.nodes()).contains("<Transform DEF='Outside'><Shape/></Transform>");
  }

  @Test
  void choicesOfASwitchAreNeitherGroupedNorUngrouped() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Switch DEF='S' whichChoice='0'><Transform DEF='A'><Shape DEF='X'/><Shape/></Transform>"
                + "<Group DEF='B'><Shape/></Group></Switch>");
    assertThatThrownBy(() -> groups(scene).ungroup(named(scene, "A")))
        .hasMessageContaining("is a choice of");
    assertThatThrownBy(
            () -> groups(scene).group(List.of(named(scene, "A"), named(scene, "B")), "G"))
        .hasMessageContaining("is a choice of");
  }

  @Test
  void ungroupedNodesStayWhereTheyAre() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform DEF='G' translation='3 1 0' rotation='1 2 0 0.7' scale='2 0.5 1'>
              <Transform DEF='T' translation='1 1 1' center='0 2 0' rotation='0 1 0 1'>
                <Shape DEF='S'/>
              </Transform>
              <!-- stays -->
              <Shape DEF='P'/>
            </Transform>
            """);
    Vector3d s = at(scene, "S", 1, 2, 3);
    Vector3d p = at(scene, "P", 1, 2, 3);
    scene.perform(groups(scene).ungroup(named(scene, "G")));
    near(at(scene, "S", 1, 2, 3), s);
    near(at(scene, "P", 1, 2, 3), p);
    assertThat(scene.nodes()).contains("\n<!-- stays -->\n").doesNotContain("DEF='G'");
    assertThat(scene.document.tree().orElseThrow().scene().orElseThrow().children()).hasSize(2);
  }

  @Test
  void whatWouldNotStayTheSameIsNotUngrouped() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform DEF='Used'><Shape/></Transform><Group><Transform USE='Used'/></Group>
            <Group DEF='Lit'><DirectionalLight/><Shape/></Group>
            <Group DEF='Touched'><TouchSensor/><Shape/></Group>
            <Group DEF='Described'><MetadataSet containerField='metadata'/><Shape/></Group>
            <Group DEF='Hidden' visible='false'><Shape/></Group>
            <Switch DEF='Choices'><Shape/></Switch>
            <Transform DEF='Moving'><Shape/></Transform>
            <ROUTE fromNode='x' fromField='value_changed' toNode='Moving' toField='translation'/>
            """);
    for (String name :
        List.of("Used", "Lit", "Touched", "Described", "Hidden", "Choices", "Moving")) {
      assertThatThrownBy(() -> groups(scene).ungroup(named(scene, name)))
          .as(name)
          .isInstanceOf(EditRejectedException.class)
          .hasMessageContaining(name);
    }
    assertThatThrownBy(
            () ->
                groups(scene)
                    .group(
                        List.of(named(scene, "Lit"), named(scene, "Lit").children().get(1)), "N"))
        .hasMessageContaining("another group");
  }

  @Test
  void aTransformDrivenByARouteStaysAndANewOneIsPutAroundIt() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Group><Transform DEF='Fan' translation='0 2 0'><Shape DEF='Blades'/></Transform></Group>
            <Transform DEF='Lift'><Shape DEF='Cabin'/></Transform>
            <Transform DEF='Faded'><Shape/></Transform>
            <OrientationInterpolator DEF='Turn'/><PositionInterpolator DEF='Rise'/>
            <ROUTE fromNode='Turn' fromField='value_changed' toNode='Fan' toField='set_rotation'/>
            <ROUTE fromNode='Rise' fromField='value_changed' toNode='Lift' toField='translation'/>
            <ROUTE fromNode='Rise' fromField='x' toNode='Faded' toField='visible'/>
            """);
    assertThat(placement(scene, "Faded").transform()).isPresent();
    Placement fan = placement(scene, "Fan");
    assertThat(fan.transform()).isEmpty();
    assertThat(fan.pose()).isEqualTo(TransformPose.IDENTITY);
    place(scene, fan.with(fan.pose().movedBy(new Vector3d(1, 0, 0))));
    assertThat(scene.nodes())
        .contains(
            "<Group><Transform translation='1 0 0'><Transform DEF='Fan' translation='0 2 0'>"
                + "<Shape DEF='Blades'/></Transform></Transform></Group>");
    Placement again = placement(scene, "Fan");
    assertThat(again.transform()).containsSame(named(scene, "Fan").parent().orElseThrow());
    place(scene, again.with(again.pose().movedBy(new Vector3d(1, 0, 0))));
    assertThat(scene.nodes()).contains("<Group><Transform translation='2 0 0'><Transform DEF");
    Placement cabin = placement(scene, "Cabin");
    place(scene, cabin.with(cabin.pose().movedBy(new Vector3d(0, 0, 3))));
    assertThat(scene.nodes())
        .contains(
            "<Transform DEF='Lift'><Transform translation='0 0 3'><Shape DEF='Cabin'/>"
                + "</Transform></Transform>");
  }

  @Test
  void aRouteInAPrototypeDrivesNoTransformOfTheSceneWithThatName() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<ProtoDeclare name='P'><ProtoBody><Transform DEF='T'/><ROUTE fromNode='I'"
                + " fromField='value_changed' toNode='T' toField='translation'/></ProtoBody>"
                + "</ProtoDeclare><Transform DEF='T'><Shape/></Transform>");
    assertThat(placement(scene, "T").transform()).containsSame(named(scene, "T"));
  }

  @Test
  void whereNoTransformMayStandNoneIsPut() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <HAnimHumanoid name='h'><HAnimJoint name='root' containerField='skeleton'>
              <HAnimSegment DEF='Pelvis' name='pelvis'/>
              <HAnimJoint DEF='Knee' name='l_knee'/>
              <HAnimJoint DEF='Hip' name='l_hip'/></HAnimJoint></HAnimHumanoid>
            <ROUTE fromNode='I' fromField='value_changed' toNode='Hip' toField='rotation'/>
            """);
    assertThat(placement(scene, "Knee").transform()).isPresent();
    for (String name : List.of("Pelvis", "Hip")) {
      assertThat(Placement.of(scene.document, CATALOGUE, named(scene, name))).as(name).isEmpty();
    }
  }

  @Test
  void lightsOfAGroupAloneBarItsUngrouping() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <PointLight DEF='Lamp' global='false'/>
            <ProtoDeclare name='Spot'><ProtoBody><SpotLight global='false'/></ProtoBody></ProtoDeclare>
            <Group DEF='Sky'><EnvironmentLight/><Shape/></Group>
            <Group DEF='Again'><PointLight USE='Lamp'/><Shape/></Group>
            <Group DEF='Instance'><ProtoInstance name='Spot'/><Shape/></Group>
            <Group DEF='Near'><PointLight global='FALSE'/><Shape/></Group>
            <Group DEF='Everywhere'><PointLight/><DirectionalLight global='true'/><Shape/></Group>
            """);
    for (String name : List.of("Sky", "Again", "Instance", "Near")) {
      assertThatThrownBy(() -> groups(scene).ungroup(named(scene, name)))
          .as(name)
          .isInstanceOf(EditRejectedException.class)
          .hasMessageContaining("belongs to this group alone");
    }
    scene.perform(groups(scene).ungroup(named(scene, "Everywhere")));
    assertThat(scene.nodes()).doesNotContain("Everywhere");
  }

  @Test
  void whatHasNoPlaceGetsNoTransformWhenUngrouped() {
    String placeless =
        """
          <TimeSensor DEF='Clock'/>
          <Script DEF='S'/>
          <PositionInterpolator DEF='P'/>
          <PositionDamper DEF='D'/>
          <BooleanFilter DEF='F'/>
          <NurbsPositionInterpolator DEF='N'/>
          <WorldInfo title='t'/>
          <KeySensor/>
          <ProtoInstance name='Tick'/>
          <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='P' toField='set_fraction'/>
        """;
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<ProtoDeclare name='Tick'><ProtoBody><TimeSensor/><Shape/></ProtoBody>"
                + "</ProtoDeclare>\n"
                + "<Transform DEF='G' translation='1 0 0'>\n"
                + placeless
                + "  <Viewpoint/>\n  <Shape DEF='Box'/>\n  <Sound/>\n</Transform>\n");
    scene.perform(groups(scene).ungroup(named(scene, "G")));
    assertThat(scene.nodes())
        .contains(placeless.replaceAll("(?m)^  ", ""))
        .contains("<Transform translation='1 0 0'>\n  <Viewpoint/>\n</Transform>")
        .contains("<Transform translation='1 0 0'>\n  <Sound/>\n</Transform>")
        .containsOnlyOnce("<Shape DEF='Box'/>");
  }

  @Test
  void typedValuesAreAPose() {
    EnrichmentScenes scene =
        EnrichmentScenes.with("<Switch DEF='W'><Group/></Switch><Group DEF='G'><Shape/></Group>\n");
    Placement of = placement(scene, "G");
    assertThat(PoseField.TRANSLATION.written(of)).isEmpty();
    set(scene, PoseField.TRANSLATION, "0 0 0"); // needs no Transform
    assertThat(scene.nodes()).contains("<Group DEF='G'>").doesNotContain("<Transform");
    set(scene, PoseField.TRANSLATION, " 1.5, 0 -2 ");
    of = placement(scene, "G");
    assertThat(PoseField.TRANSLATION.written(of)).isEqualTo("1.5 0 -2");
    set(scene, PoseField.ROTATION, "0 2 0 1.5");
    set(scene, PoseField.SCALE, "2 2 2");
    assertThat(scene.nodes())
        .contains(
            "<Transform translation='1.5 0 -2' rotation='0 2 0 1.5' scale='2 2 2'><Group DEF='G'>");
    assertThatThrownBy(() -> PoseField.ROTATION.value("0 0 0 1.57"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("0 0 0");
    set(scene, PoseField.SCALE, " ");
    assertThat(scene.nodes()).contains("scale='1 1 1'");
    for (String wrong : List.of("1", "1 2", "a b c", "1 2 3 4", "0 1 1", "1 NaN 1")) {
      assertThatThrownBy(() -> PoseField.SCALE.value(wrong))
          .as(wrong)
          .isInstanceOf(EditRejectedException.class);
    }
  }

  private void set(EnrichmentScenes scene, PoseField field, String text) {
    scene.perform(
        new PlacementEdits(scene.document)
            .set(placement(scene, "G"), field, field.value(text), "Set"));
  }

  /** What is dragged is rounded to a tenth of a millimetre; what is typed is not. */
  @Test
  void whatIsTypedIsWrittenAsItIs() {
    EnrichmentScenes scene = EnrichmentScenes.with("<Group DEF='G'><Shape/></Group>\n");
    set(scene, PoseField.TRANSLATION, "0.00004 0 1e-6");
    assertThat(scene.nodes())
        .containsPattern("<Transform translation='0.00004 0 1e-6'>\\s*<Group DEF='G'>");
    set(scene, PoseField.ROTATION, "0 0 1 0.0000001");
    assertThat(scene.nodes()).contains("rotation='0 0 1 0.0000001'");
    set(scene, PoseField.TRANSLATION, "0.00005 0 1e-6");
    assertThat(scene.nodes()).contains("translation='0.00005 0 1e-6'");
  }
}
