package org.selectiverenderer.experiment.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.hmd.Scenes;
import org.selectiverenderer.runtime.World;

class GazeTest {
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
    World world = Scenes.world(ROOM);
    Gaze.Found found = new Gaze(world, 0).find();
    assertThat(found.object()).isEqualTo("Switch_Can");
    assertThat(found.distance()).isCloseTo(4.5, within(1e-9));
    assertThat(found.version()).isEqualTo(1);
    assertThat(found.cone()).containsExactly("Switch_Can");
  }

  @Test
  void anotherVersionIsSeenWhereItStands() {
    World world = Scenes.world(ROOM);
    var can = world.scene().find("Switch_Can").orElseThrow();
    world.cascade().send(can, can.type().indexOf("whichChoice"), 0);
    world.step(1, (viewer, time, dt) -> {});
    Gaze.Found found = new Gaze(world, 0).find();
    assertThat(found.distance()).isCloseTo(3.5, within(1e-9));
    assertThat(found.version()).isZero();
  }

  @Test
  void theConeNamesWhatIsBesideToo() {
    World world = Scenes.world(ROOM);
    // Ten degrees to each side reach the lamp's near edge, not past it to the wall only.
    assertThat(new Gaze(world, 20).find().cone())
        .contains("Switch_Can", "Lamp", "Wall")
        .doesNotHaveDuplicates();
  }

  @Test
  void withoutASwitchTheNearestDefIsTheName() {
    World world = Scenes.world(ROOM);
    world.viewer().turnTo(new Quaterniond().rotationY(Math.atan2(0.8, 5)));
    Gaze.Found found = new Gaze(world, 0).find();
    assertThat(found.object()).isEqualTo("Lamp");
    assertThat(found.version()).isEqualTo(-1);
  }

  @Test
  void lookingIntoTheSkyFindsNothing() {
    World world = Scenes.world(ROOM);
    world.viewer().turnTo(new Quaterniond().rotationY(Math.PI));
    Gaze.Found found = new Gaze(world, 10).find();
    assertThat(found.object()).isEmpty();
    assertThat(found.distance()).isNaN();
    assertThat(found.cone()).isEmpty();
  }

  @Test
  void theMapHasAreasRoomsAndObjects() {
    SceneMap map = SceneSurvey.of(Scenes.world(ROOM).instances());
    assertThat(map.rooms()).extracting(SceneMap.Box::name).containsExactly("Office");
    assertThat(map.rooms().get(0).bounds()).containsExactly(-10, -10, -9.5, 10, 10, -3.5);
    assertThat(map.objects()).extracting(SceneMap.Box::name).containsExactly("Switch_Can");
    // Both versions together.
    assertThat(map.objects().get(0).bounds()[2]).isEqualTo(-5.5);
    assertThat(map.objects().get(0).bounds()[5]).isEqualTo(-3.5);
    assertThat(map.areas()).extracting(SceneMap.Area::name).containsExactly("Near");
    assertThat(map.areas().get(0).outline().get(0)).containsExactly(0, -3);
    assertThat(map.areas().get(0).outline().get(2)).containsExactly(2, 3);
  }
}
