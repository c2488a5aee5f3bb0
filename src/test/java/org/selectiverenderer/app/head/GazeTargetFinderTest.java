package org.selectiverenderer.app.head;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.TestWorlds;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.walkthrough.Walkthrough;

class GazeTargetFinderTest {
  @TempDir private Path folder;

  /** Before the viewer a can in two versions, to its left a lamp, behind both a wall. */
  private static final String ROOM =
      """
      <Viewpoint position='0 0 0'/>
      <Group DEF='Office'>
        <Switch DEF='Switch_Can' whichChoice='1'>
          <Transform DEF='Low' translation='0 0 -4'><Shape><Box size='1 1 1'/></Shape></Transform>
          <Transform DEF='High' translation='0 0 -5'><Shape><Box size='1 1 1'/></Shape></Transform>
        </Switch>
        <Transform DEF='Lamp' translation='-0.8 0 -5'><Shape><Box size='0.4 0.4 0.4'/></Shape></Transform>
        <Transform DEF='Wall' translation='0 0 -9'><Shape><Box size='20 20 1'/></Shape></Transform>
        <ProximitySensor DEF='Near' center='1 0 0' size='2 4 6'/>
      </Group>
      """;

  @Test
  void theObjectInTheMiddleIsNamedByItsSwitchWithDistanceAndVersion() {
    World world = TestWorlds.world(ROOM);
    GazeTargetFinder.Found found = new GazeTargetFinder(world, 0).find();
    assertThat(found.object()).isEqualTo("Switch_Can");
    assertThat(found.distance()).isCloseTo(4.5, within(1e-9));
    assertThat(found.version()).isEqualTo(1);
    assertThat(found.cone()).containsExactly("Switch_Can");
  }

  @Test
  void anotherVersionIsSeenWhereItStands() {
    World world = TestWorlds.world(ROOM);
    var can = world.scene().find("Switch_Can").orElseThrow();
    world.cascade().send(can, can.type().indexOf("whichChoice"), 0);
    world.step(1, (viewer, time, dt) -> {});
    GazeTargetFinder.Found found = new GazeTargetFinder(world, 0).find();
    assertThat(found.distance()).isCloseTo(3.5, within(1e-9));
    assertThat(found.version()).isZero();
  }

  @Test
  void theConeNamesWhatIsBesideToo() {
    World world = TestWorlds.world(ROOM);
    // Ten degrees to each side reach the lamp's near edge, not past it to the wall only.
    assertThat(new GazeTargetFinder(world, 20).find().cone())
        .contains("Switch_Can", "Lamp", "Wall")
        .doesNotHaveDuplicates();
  }

  @Test
  void withoutASwitchTheNearestDefIsTheName() {
    World world = TestWorlds.world(ROOM);
    world.viewer().turnTo(new Quaterniond().rotationY(Math.atan2(0.8, 5)));
    GazeTargetFinder.Found found = new GazeTargetFinder(world, 0).find();
    assertThat(found.object()).isEqualTo("Lamp");
    assertThat(found.version()).isEqualTo(-1);
  }

  @Test
  void everyObjectHasItsOwnNameWhateverItIsMadeOf() throws IOException {
    Files.writeString(
        folder.resolve("kite.x3d"),
        """
        <X3D version='4.0' profile='Immersive'><Scene>
        <Transform DEF='Tail'><Shape DEF='Knot'><Box size='0.2 0.2 0.2'/></Shape></Transform>
        </Scene></X3D>
        """);
    Path file =
        Files.writeString(
            folder.resolve("scene.x3d"),
            """
            <X3D version='4.0' profile='Immersive'><Scene>
            <Group DEF='Kitchen'>
              <Transform translation='0 -1 0'><Shape><Box size='6 0.1 6'/></Shape></Transform>
              <Transform DEF='Transform_Kite' translation='1 0 0'>
                <Inline DEF='Inline_Kite' url='"kite.x3d"'/>
              </Transform>
              <Transform DEF='Chair' translation='-1 0 0'>
                <Transform DEF='Leg'><Shape><Box size='0.1 0.5 0.1'/></Shape></Transform>
                <Transform DEF='Seat'><Shape><Box size='0.5 0.1 0.5'/></Shape></Transform>
              </Transform>
              <Transform DEF='Shelf' translation='-1 0 2'>
                <Shape><Box size='0.5 0.1 0.5'/></Shape>
                <Switch DEF='Switch_Mug' whichChoice='0'>
                  <Shape><Box size='0.1 0.1 0.1'/></Shape><Shape><Box size='0.1 0.1 0.1'/></Shape>
                </Switch>
              </Transform>
            </Group>
            <Transform DEF='Tree' translation='0 0 20'>
              <Shape DEF='Bark'><Box size='1 1 1'/></Shape>
            </Transform>
            </Scene></X3D>
            """);
    try (Walkthrough walk = open(file)) {
      named(walk.world());
    }
  }

  private static void named(World world) {
    SceneMap map = SceneMapBuilder.of(world.instances());
    assertThat(map.rooms()).extracting(SceneMap.Box::name).containsExactly("Kitchen");
    assertThat(map.objects())
        .extracting(SceneMap.Box::name)
        .containsExactly("Inline_Kite", "Chair", "Shelf", "Switch_Mug", "Tree");
    assertThat(map.surroundings()).extracting(SceneMap.Box::name).containsExactly("Kitchen");
    SceneObjectResolver objects = new SceneObjectResolver(world.instances());
    assertThat(world.instances().shapes())
        .extracting(shape -> objects.of(shape).orElseThrow().name())
        .containsExactly(
            "Kitchen",
            "Inline_Kite",
            "Chair",
            "Chair",
            "Shelf",
            "Switch_Mug",
            "Switch_Mug",
            "Tree");
  }

  @Test
  void theInconsistentObjectsOfTheApartmentAreOnItsMap() throws IOException {
    try (Walkthrough walk = open(Path.of("scenes/apartment.x3d"))) {
      SceneMap map = SceneMapBuilder.of(walk.world().instances());
      assertThat(map.rooms())
          .extracting(SceneMap.Box::name)
          .containsExactly("Kitchen", "Lounge", "Office");
      List<String> objects = map.objects().stream().map(SceneMap.Box::name).toList();
      assertThat(objects)
          .contains("Switch_Toaster", "Switch_Desk")
          .containsAll(
              Stream.of("Shovel", "Kite", "Violin", "BaseballBat", "HairDryer", "BicycleWheel")
                  .map("Inline_%s_Definition"::formatted)
                  .toList());
      assertThat(map.surroundings())
          .extracting(SceneMap.Box::name)
          .contains("Inline_KitchenFrame_Definition", "Inline_OfficeFrame_Definition")
          .doesNotContainAnyElementsOf(objects);
      map.objects().forEach(object -> assertThat(map.roomOf(object)).isNotEmpty());
    }
  }

  private static Walkthrough open(Path scene) throws IOException {
    return Walkthrough.open(
        scene, SelectiveController.Settings.SELECTIVE, problem -> {}, event -> {}, text -> {});
  }

  @Test
  void lookingIntoTheSkyFindsNothing() {
    World world = TestWorlds.world(ROOM);
    world.viewer().turnTo(new Quaterniond().rotationY(Math.PI));
    GazeTargetFinder.Found found = new GazeTargetFinder(world, 10).find();
    assertThat(found.object()).isEmpty();
    assertThat(found.distance()).isNaN();
    assertThat(found.cone()).isEmpty();
  }

  @Test
  void theMapHasAreasRoomsAndObjects() {
    SceneMap map = SceneMapBuilder.of(TestWorlds.world(ROOM).instances());
    assertThat(map.rooms()).extracting(SceneMap.Box::name).containsExactly("Office");
    assertThat(map.rooms().get(0).bounds()).containsExactly(-10, -10, -9.5, 10, 10, -3.5);
    assertThat(map.objects()).extracting(SceneMap.Box::name).containsExactly("Switch_Can", "Lamp");
    assertThat(map.surroundings()).extracting(SceneMap.Box::name).containsExactly("Wall");
    // Both versions together.
    assertThat(map.objects().get(0).bounds()[2]).isEqualTo(-5.5);
    assertThat(map.objects().get(0).bounds()[5]).isEqualTo(-3.5);
    assertThat(map.areas()).extracting(SceneMap.Area::name).containsExactly("Near");
    assertThat(map.areas().get(0).outline().get(0)).containsExactly(0, -3);
    assertThat(map.areas().get(0).outline().get(2)).containsExactly(2, 3);
  }
}
