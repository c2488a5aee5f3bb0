package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.control.ControlledSceneFixture.area;
import static org.selectiverenderer.control.ControlledSceneFixture.file;
import static org.selectiverenderer.control.ControlledSceneFixture.object;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.control.ControlEvent.Enter;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.testing.Eventually;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.networking.Inline;

/** A building whose rooms are files of their own. */
class InlinedRoomsTest {
  private static final double OUTSIDE = -5;
  private static final double AT_DESK = 0;
  private static final String ROOM =
      area("DeskProx", 0, "DeskSchema", "OfficeSchema")
          + object("DEF='TrashCan'", "DeskSchema", "OfficeSchema");
  private static final String ONE = "<Inline DEF='Office' url='\"office.x3d\"'/>";
  private @TempDir Path dir;

  @BeforeEach
  void rooms() throws IOException {
    Files.writeString(dir.resolve("office.x3d"), file(ROOM));
    Files.writeString(dir.resolve("store.x3d"), file(object("DEF='Box'", "DeskSchema", "X")));
    Files.writeString(dir.resolve("floor.x3d"), file(ONE));
  }

  private ControlledSceneFixture building(String nodes) {
    ControlledSceneFixture scene = new ControlledSceneFixture(dir, nodes);
    scene.control(Condition.SELECTIVE);
    return scene;
  }

  private static Map<String, Integer> choices(ControlledSceneFixture scene) {
    return scene.controller.choices();
  }

  private static void awaitArrival(ControlledSceneFixture scene, double place, String object) {
    Eventually.await(
        () -> object + "; there are " + choices(scene),
        () -> {
          scene.walkTo(place);
          return choices(scene).containsKey(object);
        });
  }

  @Test
  void theObjectsOfARoomFollowItsAreasInTheSameFrame() {
    try (var scene = building(ONE)) {
      scene.walkTo(OUTSIDE);
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 1));
      scene.news();

      scene.walkTo(AT_DESK);

      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 0));
      assertThat(scene.news())
          .satisfiesExactly(
              event -> assertThat(((Enter) event).sensor()).isEqualTo("DeskProx"),
              event -> {
                assertThat(((SwitchChange) event).switchName()).isEqualTo("TrashCan");
                assertThat(event.time()).isEqualTo(2);
              });
      scene.walkTo(OUTSIDE);
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 1));
    }
  }

  @Test
  void anAreaOfTheBuildingGovernsObjectsOfItsRooms() {
    try (var scene =
        building(area("DeskProx", 0, "DeskSchema", "") + "<Inline url='\"store.x3d\"'/>")) {
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEqualTo(Map.of("Box", 0));
      assertThat(scene.problems)
          .extracting(ControlProblem::message)
          .noneMatch(m -> m.contains("DeskSchema"));
    }
  }

  @Test
  void aRoomWithinAFileWithinAFileIsFound() {
    try (var scene = building("<Transform><Inline url='\"floor.x3d\"'/></Transform>")) {
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 0));
    }
  }

  @Test
  void aFileInlinedTwiceIsTwoRoomsWithAreasOfTheirOwn() {
    try (var scene =
        building(
            ONE + "<Transform translation='10 0 0'><Inline url='\"office.x3d\"'/></Transform>")) {
      scene.walkTo(OUTSIDE);
      scene.news();

      scene.walkTo(10);

      assertThat(scene.controller.enteredAreas()).containsExactly("Inline#2/DeskProx");
      assertThat(choices(scene)) // One schema, as if both rooms stood in one file.
          .isEqualTo(Map.of("Office/TrashCan", 0, "Inline#2/TrashCan", 0));
      scene.walkTo(AT_DESK);
      assertThat(scene.controller.enteredAreas()).containsExactly("Office/DeskProx");
    }
  }

  @Test
  void aNodeOfTheBuildingKeepsItsNameWhereARoomHasTheSameOne() {
    try (var scene = building(object("DEF='TrashCan'", "A", "B") + ONE)) {
      assertThat(choices(scene)).containsOnlyKeys("TrashCan", "Office/TrashCan");
    }
  }

  @Test
  void aRoomThatIsSwitchedOffAndOnIsForgottenAndFoundAgain() {
    try (var scene = building(ONE)) {
      scene.walkTo(AT_DESK);
      Inline office = (Inline) scene.node("Office");

      office.setLoad(false);
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEmpty();
      assertThat(scene.controller.enteredAreas()).isEmpty();

      scene.walkTo(OUTSIDE);
      office.setLoad(true);
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 0));
      assertThat(scene.controller.enteredAreas()).containsExactly("DeskProx");
    }
  }

  @Test
  void aRoomThatArrivesLateFollowsTheAreasTheViewerIsIn() {
    try (var scene =
        building(
            area("P", 0, "DeskSchema", "")
                + "<Inline DEF='Room' load='false' url='\"store.x3d\"'/>")) {
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEmpty();

      ((Inline) scene.node("Room")).setLoad(true);
      awaitArrival(scene, AT_DESK, "Box");

      assertThat(choices(scene)).isEqualTo(Map.of("Box", 0));
    }
  }

  @Test
  void aRoomIsReplacedByAnother() {
    try (var scene = building(ONE)) {
      scene.walkTo(AT_DESK);
      Inline office = (Inline) scene.node("Office");

      office.setUrl(new String[] {"store.x3d"});
      awaitArrival(scene, AT_DESK, "Box");

      assertThat(choices(scene)).isEqualTo(Map.of("Box", 1)); // Its area went with the room.
      assertThat(scene.controller.enteredAreas()).isEmpty();
      office.setUrl(new String[] {"office.x3d"});
      awaitArrival(scene, AT_DESK, "TrashCan");
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 0));
    }
  }

  @Test
  void aRoomThatIsTakenAwayLeavesNoListenerBehind() {
    try (var scene = building("<Group DEF='Rooms'>" + ONE + "</Group>")) {
      scene.walkTo(AT_DESK);
      var office = (Inline) scene.node("Office");
      X3DScene content = scene.browser.inlinedScene(office).orElseThrow();
      ((X3DGroupingNode) scene.node("Rooms")).setChildren(new X3DNode[0]);
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEmpty();

      content.addRootNode(content.createNode("Switch"));
      office.setLoad(false);
      scene.walkTo(AT_DESK);
      assertThat(scene.world.problems().list()).isEmpty();
    }
  }

  @Test
  void aNodeAddedAtTheTopOfARoomIsFound() {
    try (var scene = building(area("P", 0, "DeskSchema", "") + ONE)) {
      scene.walkTo(OUTSIDE);
      X3DScene content = scene.browser.inlinedScene(scene.node("Office")).orElseThrow();
      var can = content.getNamedNode("TrashCan");
      content.removeRootNode(can);
      scene.walkTo(OUTSIDE);
      assertThat(choices(scene)).isEmpty();
      content.addRootNode(can);
      scene.walkTo(AT_DESK);
      assertThat(choices(scene)).isEqualTo(Map.of("TrashCan", 0));
    }
  }

  @Test
  void instancesOfAPrototypeAreControlledEachByItself() {
    String prototype =
        "<ProtoDeclare name='Room'><ProtoBody><Group>"
            + ROOM
            + "</Group></ProtoBody></ProtoDeclare>";
    try (var scene =
        building(
            prototype
                + "<ProtoInstance name='Room' DEF='A'/>"
                + "<Transform translation='10 0 0'><ProtoInstance name='Room' DEF='B'/></Transform>")) {
      scene.walkTo(10);
      assertThat(choices(scene).values()).containsExactly(0, 0);
      assertThat(scene.controller.enteredAreas()).hasSize(1);
    }
  }

  @Test
  void objectsAndAreasBehindInterfacesAreControlledAndKeepTheirNames() {
    String prototypes =
        "<ProtoDeclare name='Object'><ProtoInterface>"
            + "<field name='content' type='MFNode' accessType='inputOutput'/></ProtoInterface>"
            + "<ProtoBody>"
            + object("", "DeskSchema", "OfficeSchema")
            + "</ProtoBody></ProtoDeclare>"
            + "<ProtoDeclare name='Area'><ProtoBody>"
            + area("DeskProx", 0, "DeskSchema", "OfficeSchema")
            + "</ProtoBody></ProtoDeclare>";
    try (var scene =
        building(
            prototypes
                + "<ProtoInstance name='Area'/><Group><ProtoInstance name='Object' DEF='Lamp'/>"
                + "</Group>")) {
      scene.walkTo(AT_DESK);
      assertThat(choices(scene).keySet()).containsExactly("Lamp");
      assertThat(scene.controller.enteredAreas()).hasSize(1);
    }
  }

  @Test
  void aBrowserThatKeepsInlinesClosedIsSaidOnce() {
    try (var scene = new ControlledSceneFixture(dir, ONE + ONE.replace("Office", "Other"))) {
      List<ControlProblem> problems = new ArrayList<>();
      try (var controller =
          new SelectiveController(
              closed(scene.browser), Settings.SELECTIVE, event -> {}, problems::add)) {
        assertThat(controller.choices()).isEmpty();
      }
      assertThat(problems)
          .singleElement()
          .satisfies(
              problem -> {
                assertThat(problem.severity()).isEqualTo(ControlProblem.Severity.INFO);
                assertThat(problem.message())
                    .startsWith("this browser does not show nodes inside Inlines");
              });
    }
  }

  @Test
  void inlinesOfVersionsAreNoReasonToMention() {
    String versions =
        object("DEF='S'", "A", "B").replaceFirst("<Group/>", "<Inline url='\"store.x3d\"'/>");
    try (var scene = new ControlledSceneFixture(dir, area("P", 0, "A", "B") + versions)) {
      List<ControlProblem> problems = new ArrayList<>();
      new SelectiveController(closed(scene.browser), Settings.SELECTIVE, event -> {}, problems::add)
          .close();
      assertThat(problems).isEmpty();
    }
  }

  /** A browser with the standard's methods only. */
  private static ExternalBrowser closed(ExternalBrowser open) {
    return (ExternalBrowser)
        Proxy.newProxyInstance(
            InlinedRoomsTest.class.getClassLoader(),
            new Class<?>[] {ExternalBrowser.class},
            (proxy, method, arguments) -> method.invoke(open, arguments));
  }
}
