package org.selectiverenderer.hmd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.browser.viewer.YawPitch;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.replay.FrameSteppedReplay;
import org.selectiverenderer.tracker.replay.ReplayLog;

class HeadTrackedMotionTest {
  private static final ViewerMotion STANDING = (viewer, time, dt) -> {};

  @TempDir private Path folder;

  private FrameSteppedReplay tracker(String rows) throws IOException {
    Path file = folder.resolve("head.csv");
    Files.writeString(file, "t,yaw,pitch,roll\n" + rows);
    ReplayLog log = ReplayLog.read(file, new ProblemCollector()).orElseThrow();
    return new FrameSteppedReplay(new TrackerSpec.Replay(file), log, TrackerOptions.NONE);
  }

  private static void assertLooks(World world, double yaw, double pitch, double roll) {
    Quaterniond expected =
        new Quaterniond()
            .rotationYXZ(Math.toRadians(yaw), Math.toRadians(pitch), Math.toRadians(roll));
    assertThat(Math.abs(world.viewer().orientation().difference(expected, new Quaterniond()).w))
        .as("towards %s %s %s", yaw, pitch, roll)
        .isCloseTo(1, within(1e-9));
  }

  @Test
  void theHeadTurnsTheViewFromWhereTheViewpointLooks() throws IOException {
    // The viewpoint looks 90 degrees to the left.
    World world =
        TestWorlds.world("<Viewpoint position='0 0 0' orientation='0 1 0 1.5707963267948966'/>");
    FrameSteppedReplay head = tracker("0,0,0,0\n1,30,-10,5\n");
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, STANDING, WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    assertLooks(world, 90, 0, 0);
    head.advanceTo(1);
    world.step(2, motion);
    assertLooks(world, 120, -10, 5);
    assertThat(motion.steering()).isTrue();
    assertThat(motion.fresh()).isTrue();
    world.step(3, motion);
    assertLooks(world, 120, -10, 5);
    assertThat(motion.fresh()).isFalse();
  }

  @Test
  void theHeadTurnsAllTheWayRoundAndStraightUpAndDown() throws IOException {
    World world = TestWorlds.world("<Viewpoint position='0 0 0'/>");
    StringBuilder rows = new StringBuilder();
    for (int i = 0; i <= 36; i++) {
      rows.append(i + "," + (10 * i - 180) + "," + (5 * i - 90) + ",7\n");
    }
    FrameSteppedReplay head = tracker(rows.toString());
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, STANDING, WhenLost.FREEZE);
    for (int i = 0; i <= 36; i++) {
      head.advanceTo(i);
      world.step(1 + i, motion);
      assertLooks(world, 10 * i - 180, 5 * i - 90, 7);
    }
  }

  @Test
  void walkingFollowsTheHeadAndSteeringTurnsTheChair() throws IOException {
    World world = TestWorlds.world("<Viewpoint position='0 0 0'/>");
    FrameSteppedReplay head = tracker("0,-90,0,0\n1,-90,20,15\n");
    ViewerMotion ahead =
        (viewer, time, dt) -> {
          YawPitch heading = YawPitch.of(viewer.orientation());
          viewer.moveTo(viewer.position().add(heading.level(1, 0), new Vector3d()));
          // A tenth of a radian to the left, upright as a walker leaves it.
          viewer.turnTo(new YawPitch(heading.yaw() + 0.1, heading.pitch()).orientation());
        };
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, ahead, WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    // The head looks right, along +X; the step goes there, then the chair turns.
    assertThat(world.viewer().position().x()).isCloseTo(1, within(1e-9));
    assertThat(world.viewer().position().z()).isCloseTo(0, within(1e-9));
    assertLooks(world, -90 + Math.toDegrees(0.1), 0, 0);
    head.advanceTo(1);
    world.step(2, motion);
    assertLooks(world, -90 + Math.toDegrees(0.2), 20, 15);
  }

  @Test
  void resettingTheHeadingMakesTheHeadsDirectionStraightAhead() throws IOException {
    World world = TestWorlds.world("<Viewpoint position='0 0 0'/>");
    FrameSteppedReplay head = tracker("0,75,10,0\n1,85,10,0\n");
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, STANDING, WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    assertLooks(world, 75, 10, 0);
    head.resetHeading();
    world.step(2, motion);
    assertLooks(world, 0, 10, 0);
    head.advanceTo(1);
    world.step(3, motion);
    assertLooks(world, 10, 10, 0);
  }

  @Test
  void goingToAViewpointTurnsTheChairSoThatItsViewIsSeen() throws IOException {
    World world =
        TestWorlds.world(
            "<Viewpoint position='0 0 0'/>"
                + "<Viewpoint DEF='Right' position='3 0 0' orientation='0 1 0 -1.5707963267948966'/>");
    FrameSteppedReplay head = tracker("0,20,0,0\n1,50,0,0\n");
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, STANDING, WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    world.views().goTo(world.scene().find("Right").orElseThrow());
    world.step(2, motion);
    assertLooks(world, -90, 0, 0);
    assertThat(world.viewer().position()).isEqualTo(new Vector3d(3, 0, 0));
    head.advanceTo(1);
    world.step(3, motion);
    assertLooks(world, -60, 0, 0);
  }

  @Test
  void withoutAPoseYetOtherMotionTurnsTheView() throws IOException {
    World world = TestWorlds.world("<Viewpoint position='0 0 0'/>");
    FrameSteppedReplay head = tracker("5,10,0,0\n");
    ViewerMotion looking =
        (viewer, time, dt) ->
            viewer.turnTo(new Quaterniond(viewer.orientation()).rotateY(Math.toRadians(3)));
    HeadTrackedMotion motion = new HeadTrackedMotion(world, head, looking, WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    assertThat(motion.steering()).isFalse();
    assertLooks(world, 3, 0, 0);
  }

  @Test
  void aProximitySensorSeesWhatIsDrawn() throws IOException {
    World world =
        TestWorlds.world(
            "<Viewpoint position='0 0 0'/><ProximitySensor DEF='Near' size='10 10 10'/>");
    FrameSteppedReplay head = tracker("0,40,0,0\n");
    HeadTrackedMotion motion =
        new HeadTrackedMotion(
            world,
            head,
            (viewer, time, dt) -> viewer.moveTo(new Vector3d(1, 2, 3)),
            WhenLost.FREEZE);
    head.advanceTo(0);
    world.step(1, motion);
    var sensor = world.scene().find("Near").orElseThrow();
    assertThat((float[]) sensor.value(sensor.type().indexOf("position_changed")))
        .containsExactly(1, 2, 3);
    assertThat((float[]) sensor.value(sensor.type().indexOf("orientation_changed")))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(0, 1, 0, (float) Math.toRadians(40));
  }
}
