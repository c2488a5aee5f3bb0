package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.control.ControlledSceneFixture.area;
import static org.selectiverenderer.control.ControlledSceneFixture.object;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.Enter;
import org.selectiverenderer.control.ControlEvent.Start;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.schema.Condition;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.core.MetadataSet;
import org.web3d.x3d.sai.core.MetadataString;
import org.web3d.x3d.sai.grouping.Switch;

/** The scene is changed through the SAI while the controller works. */
class ChangingSceneTest {
  private static final String DESK = area("DeskProx", 0, "DeskSchema", "OfficeSchema");
  private static final String TRASH_CAN = object("DEF='TrashCan'", "DeskSchema", "OfficeSchema");
  private static final double OUTSIDE = -5;
  private static final double AT_DESK = 0;

  private static MetadataString string(ControlledSceneFixture scene, String name, String value) {
    MetadataString string = (MetadataString) scene.scene().createNode("MetadataString");
    string.setName(name);
    string.setValue(new String[] {value});
    return string;
  }

  private static MetadataSet set(ControlledSceneFixture scene, X3DNode... children) {
    MetadataSet set = (MetadataSet) scene.scene().createNode("MetadataSet");
    set.setValue(children);
    return set;
  }

  private static Switch newObject(ControlledSceneFixture scene, String schema) {
    Switch node = (Switch) scene.scene().createNode("Switch");
    node.setChildren(new X3DNode[] {scene.scene().createNode("Group")});
    node.setMetadata(set(scene, set(scene, string(scene, "schemaBelonginess", schema))));
    return node;
  }

  @Test
  void aSwitchThatIsAddedFollowsTheEnteredAreas() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + "<Group DEF='G'/>")) {
      scene.walkTo(AT_DESK);
      scene.news();

      Switch added = newObject(scene, "DeskSchema");
      ((X3DGroupingNode) scene.node("G")).addChildren(new X3DNode[] {added});
      scene.walkTo(AT_DESK);

      assertThat(added.getWhichChoice()).isZero();
      assertThat(scene.controller.choices()).isEqualTo(Map.of("Switch#1", 0));
      assertThat(scene.news())
          .singleElement()
          .isInstanceOfSatisfying(
              SwitchChange.class, change -> assertThat(change.schema()).isEqualTo("DeskSchema"));
    }
  }

  @Test
  void aChoiceThatSomebodyElseSetIsKnownToTheNextActivation() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(AT_DESK);
      ((Switch) scene.node("TrashCan")).setWhichChoice(1);
      scene.walkTo(AT_DESK);
      assertThat(scene.controller.choices()).isEqualTo(Map.of("TrashCan", 1));
      scene.walkTo(OUTSIDE);
      scene.news();
      scene.walkTo(AT_DESK);
      assertThat(scene.choice("TrashCan")).isZero();
      ((Switch) scene.node("TrashCan")).setWhichChoice(-1);
      scene.news();
      scene.walkTo(OUTSIDE);

      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.news()).contains(new SwitchChange(5, "TrashCan", -1, 1, "OfficeSchema"));
    }
  }

  @Test
  void aRouteThatSetsTheChoiceIsOverruledByTheNextActivation() {
    String hack =
        "<Transform translation='9 0 0'><ProximitySensor DEF='Hack' size='2 2 2'/></Transform>"
            + "<IntegerTrigger DEF='T' integerKey='0'/>"
            + "<ROUTE fromNode='Hack' fromField='isActive' toNode='T' toField='set_boolean'/>"
            + "<ROUTE fromNode='T' fromField='triggerValue' toNode='TrashCan'"
            + " toField='whichChoice'/>";
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN + hack)) {
      scene.walkTo(AT_DESK);
      scene.walkTo(OUTSIDE);
      scene.walkTo(9);
      assertThat(scene.controller.choices()).isEqualTo(Map.of("TrashCan", 0));
      scene.walkTo(AT_DESK);
      scene.news();
      scene.walkTo(OUTSIDE);

      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.news()).contains(new SwitchChange(5, "TrashCan", 0, 1, "OfficeSchema"));
    }
  }

  @Test
  void aSwitchThatIsTakenAwayIsLeftAlone() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE, DESK + "<Group DEF='G'>" + TRASH_CAN + "</Group>")) {
      scene.walkTo(OUTSIDE);
      Switch trashCan = (Switch) scene.node("TrashCan");
      ((X3DGroupingNode) scene.node("G")).removeChildren(new X3DNode[] {trashCan});
      scene.walkTo(AT_DESK);

      assertThat(trashCan.getWhichChoice()).isEqualTo(1);
      assertThat(scene.controller.choices()).isEmpty();
    }
  }

  @Test
  void aSwitchThatStaysInAnotherPlaceIsStillFollowed() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE,
            DESK + "<Group DEF='G'>" + TRASH_CAN + "</Group><Switch USE='TrashCan'/>")) {
      scene.walkTo(OUTSIDE);
      ((X3DGroupingNode) scene.node("G")).setChildren(new X3DNode[0]);
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("TrashCan")).isZero();
    }
  }

  @Test
  void anotherSchemaInAMetadataStringCounts() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE,
            DESK
                + "<Switch DEF='Vase'><Group/><MetadataString DEF='Schema'"
                + " containerField='metadata' name='schemaBelonginess' value='\"X\"'/></Switch>")) {
      scene.walkTo(AT_DESK);
      assertThat(scene.choice("Vase")).isEqualTo(-1);

      ((MFString) scene.node("Schema").getField("value")).set1Value(0, "DeskSchema");
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("Vase")).isZero();
    }
  }

  @Test
  void metadataThatReplacesOtherMetadataCounts() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      X3DMetadataObject elsewhere =
          set(scene, set(scene, string(scene, "schemaBelonginess", "SofaSchema")));
      scene.node("TrashCan").setMetadata(elsewhere);
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.controller.problems())
          .extracting(ControlProblem::message)
          .containsExactly(
              "1 MetadataSet for 2 children of the Switch; no schema shows the other "
                  + "children");
    }
  }

  @Test
  void aSensorThatIsEnrichedWhileTheViewerIsInItCountsAsEntered() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE, "<ProximitySensor DEF='P' size='2 2 2'/>" + TRASH_CAN)) {
      scene.walkTo(AT_DESK);
      scene.news();
      scene.node("P").setMetadata(string(scene, "enterTimeSchema", "DeskSchema"));
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("TrashCan")).isZero();
      assertThat(scene.news()).hasAtLeastOneElementOfType(Enter.class);
    }
  }

  @Test
  void aSensorThatIsTakenAwayClaimsNothing() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE,
            area("Room", 0, "OfficeSchema", "HallSchema")
                + "<Group DEF='G'>"
                + DESK
                + "</Group>"
                + TRASH_CAN)) {
      scene.walkTo(AT_DESK);
      assertThat(scene.choice("TrashCan")).isZero();
      ((X3DGroupingNode) scene.node("G")).setChildren(new X3DNode[0]);
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.controller.enteredAreas()).containsExactly("Room");
    }
  }

  @Test
  void nodesAddedAtTheTopAreFoundAndThoseRemovedAreLeftAlone() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK)) {
      scene.walkTo(AT_DESK);
      Switch added = newObject(scene, "DeskSchema");
      scene.scene().addRootNode(added);
      scene.walkTo(AT_DESK);
      assertThat(added.getWhichChoice()).isZero();

      scene.scene().removeRootNode(added);
      scene.walkTo(AT_DESK);
      assertThat(scene.controller.choices()).isEmpty();
    }
  }

  @Test
  void problemsThatComeLaterAreReportedOnce() {
    String wrong =
        DESK
            + "<Switch DEF='Lamp'><Group/><Group/><MetadataString containerField='metadata'"
            + " name='schemaBelonginess' value='\"DeskSchema\"'/></Switch>";
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      assertThat(scene.problems).isEmpty();
      scene.node("TrashCan").setMetadata(string(scene, "schemaBelonginess", "DeskSchema"));
      scene.walkTo(OUTSIDE);
      assertThat(scene.problems).extracting(ControlProblem::nodeName).containsExactly("TrashCan");
      scene.browser.replaceWorld(
          scene.browser.createX3DFromString(ControlledSceneFixture.file(wrong)));
      scene.walkTo(OUTSIDE);

      assertThat(scene.problems)
          .extracting(ControlProblem::nodeName)
          .containsExactly("TrashCan", "Lamp");
    }
  }

  @Test
  void aWriteThatFailsIsReported() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      scene.node("TrashCan").dispose();
      scene.walkTo(AT_DESK);

      assertThat(scene.problems)
          .singleElement()
          .asString()
          .startsWith("TrashCan: whichChoice cannot be set to 0: ");
    }
  }

  @Test
  void anotherWorldIsTakenOver() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      Switch before = (Switch) scene.node("TrashCan");
      scene.news();
      scene.browser.replaceWorld(
          scene.browser.createX3DFromString(
              ControlledSceneFixture.file(
                  DESK + object("DEF='Lamp'", "DeskSchema", "OfficeSchema"))));
      scene.walkTo(OUTSIDE);
      assertThat(scene.news()).containsExactly(new Start(0, Map.of("Lamp", 1)));
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("Lamp")).isZero();
      Switch added = newObject(scene, "DeskSchema");
      scene.scene().addRootNode(added);
      scene.walkTo(AT_DESK);
      assertThat(added.getWhichChoice()).isZero();
      assertThat(before.getWhichChoice()).isEqualTo(1);
    }
  }
}
