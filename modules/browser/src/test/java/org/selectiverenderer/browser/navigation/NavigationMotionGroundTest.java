package org.selectiverenderer.browser.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.geometry.mesh.TestMeshes;

/** Steps, ramps, gravity and what holds a walker up. */
class NavigationMotionGroundTest extends NavigationMotionTestCase {
  @Test
  void stepsAreClimbedUpToTheStepHeightAndNotAbove() {
    world.add(TestMeshes.floor(0, 50));
    for (int i = 0; i < 5; i++) {
      world.add(TestMeshes.box(-2, 0, -20, 2, 0.3 * (i + 1), -2 - 0.4 * i));
    }
    world.add(TestMeshes.box(-2, 0, -20, 2, 1.81, -6));
    motion = MotionRequest.ahead(1);
    run(walker(), 10, FRAME);
    assertAt(0, 1.5 + 1.6, -5.75, 1e-3);
  }

  @Test
  void rampsAreWalkedUpAndDownWithTheEyeAtItsHeight() {
    world.add(TestMeshes.floor(0, 50));
    world.add(
        TestMeshes.quad(true, -2, 0, -1, 2, 0, -1, 2, 3, -5, -2, 3, -5),
        TestMeshes.quad(true, -2, 3, -5, 2, 3, -5, 2, 0, -9, -2, 0, -9));
    motion = MotionRequest.ahead(1);
    NavigationMotion walker = walker();
    for (int i = 0; i < 600; i++) {
      run(walker, FRAME, FRAME);
      double ground = Math.max(0, 3 - 0.75 * Math.abs(viewer.position().z() + 5));
      assertThat(viewer.position().y()).isCloseTo(ground + 1.6, within(1e-3));
    }
    assertThat(viewer.position().z()).isCloseTo(-10, within(0.05));
  }

  @Test
  void withoutStepHeightARampIsStillGround() {
    world.add(
        TestMeshes.floor(0, 50), TestMeshes.quad(true, -2, 0, -1, 2, 0, -1, 2, 3, -5, -2, 3, -5));
    NavigationMotion walker = walker();
    walker.use(
        new NavigationParameters(List.of(NavigationMode.WALK), 0.25, 1.6, 0, 1),
        ViewpointFrame.WORLD);
    motion = MotionRequest.ahead(1);
    run(walker, 3, FRAME);
    assertAt(0, 1.6 + 1.5, -3, 0.01);
  }

  @Test
  void fallingFollowsGravityAndEndsAtTheEyesHeight() {
    world.add(TestMeshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 11.6, 0));
    NavigationMotion walker = walker();
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(11.6 - 9.81 / 2, within(1e-6));
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void aLongFrameDoesNotFallThroughTheGround() {
    world.add(TestMeshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 30, 0));
    run(walker(), 10, 1);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void whereNoGroundIsNothingFalls() {
    world.add(TestMeshes.floor(0, 2));
    motion = MotionRequest.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -5, 1e-6);
  }

  @Test
  void oneWhoBeginsInTheGroundStandsUp() {
    world.add(TestMeshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 0.4, 0));
    run(walker(), 0.1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void underALowCeilingItDoesNotStepUp() {
    world.add(TestMeshes.floor(0, 50));
    world.add(TestMeshes.box(-2, 0, -9, 2, 0.3, -2), TestMeshes.box(-2, 1.8, -9, 2, 2, -2.1));
    motion = MotionRequest.ahead(1);
    run(walker(), 5, FRAME);
    assertThat(viewer.position().z()).isGreaterThan(-2.2);
    assertThat(viewer.position().y()).isLessThan(1.8);
  }

  @Test
  void aTableThatIsOnlyATopHoldsItUp() {
    world.add(
        TestMeshes.floor(0, 50), TestMeshes.quad(false, -1, 1, -2, 1, 1, -2, 1, 1, -4, -1, 1, -4));
    motion = MotionRequest.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -1.75, 1e-3);
  }

  @Test
  void withoutCollisionsWallsAreNoObstacleButTheGroundIsGround() {
    world.add(TestMeshes.floor(0, 50), TestMeshes.box(-5, 0, -3.2, 5, 3, -3));
    NavigationMotion walker = walker();
    walker.collisions(false);
    motion = MotionRequest.ahead(1);
    run(walker, 5, FRAME);
    assertAt(0, 1.6, -5, 1e-6);
  }
}
