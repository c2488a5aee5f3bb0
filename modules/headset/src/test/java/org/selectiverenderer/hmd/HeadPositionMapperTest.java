package org.selectiverenderer.hmd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.CollisionWorld;
import org.selectiverenderer.browser.navigation.MotionRequest;
import org.selectiverenderer.browser.navigation.NavigationMotion;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.pipeline.HeadsetPoseTracker;

class HeadPositionMapperTest {
  /** A floor of ten metres, with a wall two metres in front of the middle. */
  private static final String ROOM =
      "<Viewpoint position='0 1.6 0' orientation='0 1 0 %s'/>"
          + "<Transform translation='0 -0.05 0'><Shape><Box size='10 0.1 10'/></Shape></Transform>"
          + "<Transform translation='0 1.5 -2.05'><Shape><Box size='10 3 0.1'/></Shape></Transform>"
          + "<ProximitySensor DEF='NEAR' center='1 1.5 0' size='0.6 3 0.6'/>";

  private final HeadsetPoseTracker tracker = new HeadsetPoseTracker(problem -> {}, () -> "");
  private final PoseSample pose = new PoseSample();
  private double time;
  private MotionRequest wish = MotionRequest.NONE;

  private World world;
  private HeadTrackedMotion motion;

  /** Puts somebody there whose head is tracked above a body that is led. */
  private void stand(World in, boolean floor, double size) {
    world = in;
    NavigationMotion walker =
        new NavigationMotion(
            new CollisionWorld(world.instances(), world.assets(), world.meshes()), dt -> wish);
    walker.use(NavigationParameters.WALKING, ViewpointFrame.WORLD);
    motion =
        new HeadTrackedMotion(
            world,
            tracker,
            walker,
            WhenLost.FREEZE,
            new HeadTrackingOptions(true, () -> floor, size),
            walker::push);
  }

  private static World room(double turned) throws IOException {
    return TestWorlds.world(ROOM.formatted(turned));
  }

  private void head(double yaw, double... place) {
    pose.turn(yaw, 0, 0);
    pose.place(place[0], place[1], place[2]);
    tracker.hand(pose, System.nanoTime());
    time += 0.1;
    world.step(time, motion);
  }

  private void assertAt(double x, double y, double z) {
    Vector3dc at = world.viewer().position();
    assertThat(at.distance(new Vector3d(x, y, z))).as("at %s", at).isLessThan(1e-3);
  }

  @Test
  void theHeadOfOneWhoStandsIsAsHighAsItIs() throws IOException {
    stand(room(0), true, 1);
    head(0, 5, 1.7, 3);
    assertAt(0, 1.7, 0);
    head(0, 5.3, 1.2, 3.4);
    assertAt(0.3, 1.2, 0.4);
  }

  @Test
  void theHeadOfOneWhoSitsIsAsHighAsTheSceneSays() throws IOException {
    stand(room(0), false, 1);
    head(0, 0, 0.2, 0);
    assertAt(0, 1.6, 0);
    head(0, 0, 0.1, 0);
    assertAt(0, 1.5, 0);
  }

  @Test
  void theRoomOfTheTrackerTurnsWithTheChair() throws IOException {
    stand(room(Math.PI / 2), true, 1); // The viewpoint looks to -X.
    head(0, 0, 1.6, 0);
    head(0, 0, 1.6, -0.5);
    assertAt(-0.5, 1.6, 0);
  }

  @Test
  void straighteningTurnsTheRoomSoThatTheHeadLooksAhead() throws IOException {
    stand(room(0), true, 1);
    tracker.straighten();
    head(90, 2, 1.6, 2); // Looks to the room's -X.
    assertAt(0, 1.6, 0);
    head(90, 1.5, 1.6, 2); // Half a metre the way it looks.
    assertAt(0, 1.6, -0.5);
  }

  @Test
  void aLargerUserSeesEverythingSmaller() throws IOException {
    stand(room(0), true, 2);
    head(0, 0, 1.7, 0);
    head(0, 0.1, 1.7, 0);
    assertAt(0.2, 3.4, 0);
  }

  @Test
  void theBodyFollowsTheHeadAndWallsHoldItUp() throws IOException {
    stand(room(0), true, 1);
    head(0, 0, 1.6, 0);
    for (int i = 1; i <= 20; i++) {
      head(0, 0, 1.6, -0.1 * i); // Two metres, to the wall.
    }
    // The body stops a quarter of a metre before it, and the head leans over by what is left.
    assertThat(world.viewer().position().z()).isCloseTo(-2, within(1e-2));
    for (int i = 21; i <= 40; i++) {
      head(0, 0, 1.6, -0.1 * i); // Two more: the room comes along.
    }
    assertThat(world.viewer().position().z())
        .isCloseTo(-1.75 - HeadPositionMapper.LEAN, within(2e-2));
    head(0, 0, 1.6, -3.5); // And back: at once by as much as the head goes.
    assertThat(world.viewer().position().z())
        .isCloseTo(-1.25 - HeadPositionMapper.LEAN, within(2e-2));
  }

  @Test
  void sensorsSeeTheRealHead() throws IOException {
    stand(room(0), true, 1);
    Node sensor = world.scene().find("NEAR").orElseThrow();
    head(0, 0, 1.6, 0);
    assertThat(sensor.bool("isActive")).isFalse();
    head(0, 0.8, 1.6, 0);
    assertThat(sensor.bool("isActive")).isTrue();
    head(0, 0.2, 1.6, 0);
    assertThat(sensor.bool("isActive")).isFalse();
  }

  @Test
  void walkingGoesTheWayTheHeadLooksFromBelowTheHead() throws IOException {
    stand(room(0), true, 1);
    head(-90, 0, 1.7, 0); // Looks to +X.
    head(-90, 0, 1.7, 0.5);
    wish = MotionRequest.ahead(1);
    head(-90, 0, 1.7, 0.5);
    assertAt(0.1, 1.7, 0.5);
  }

  @Test
  void anotherViewpointTakesTheBodyThere() throws IOException {
    stand(
        TestWorlds.world(
            "<Viewpoint position='0 1.6 0'/><Viewpoint DEF='B' position='3 1.6 3'/>"
                + "<Transform translation='0 -0.05 0'><Shape><Box size='10 0.1 10'/></Shape></Transform>"),
        false,
        1);
    head(0, 0, 0, 0);
    head(0, 0.2, 0, 0);
    world.views().goTo(world.views().viewpoints().get(1));
    head(0, 0.2, 0, 0);
    assertAt(3, 1.6, 3);
    head(0, 0.3, 0, 0);
    assertAt(3.1, 1.6, 3);
  }

  @Test
  void aTrackerWhosePlaceIsNotUsedTurnsTheHeadAlone() throws IOException {
    world = room(0);
    motion = new HeadTrackedMotion(world, tracker, (viewer, now, dt) -> {}, WhenLost.FREEZE);
    head(10, 1, 1, 1);
    assertAt(0, 1.6, 0);
  }
}
