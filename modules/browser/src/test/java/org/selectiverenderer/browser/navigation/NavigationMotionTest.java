package org.selectiverenderer.browser.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.geometry.mesh.TestMeshes;

/** Walking ahead, along walls and through doorways. */
class NavigationMotionTest extends NavigationMotionTestCase {
  private static Quaterniond walkerUpright(Matrix4d place) {
    return new Quaterniond(ViewpointFrame.of(place).upright());
  }

  @Test
  void walksAheadAtTheSpeedOfTheNavigationInfo() {
    world.add(TestMeshes.floor(0, 50));
    motion = MotionRequest.ahead(1);
    run(walker(), 3, FRAME);
    assertAt(0, 1.6, -3, 1e-6);
  }

  @Test
  void diagonallyItIsNoFaster() {
    world.add(TestMeshes.floor(0, 50));
    motion = new MotionRequest(1, 1, 0, 0, 0, 0, 2);
    run(walker(), 1, FRAME);
    assertAt(Math.sqrt(2), 1.6, -Math.sqrt(2), 1e-6);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0 / 240, 1.0 / 60, 0.1, 1})
  void aWallStopsItAtTheCollisionDistance(double dt) {
    world.add(TestMeshes.floor(0, 50), TestMeshes.box(-5, 0, -3.001, 5, 3, -3));
    motion = new MotionRequest(1, 0, 0, 0, 0, 0, 20);
    run(walker(), 5, dt);
    assertAt(0, 1.6, -2.75, 1e-3);
  }

  @Test
  void aWallIsSolidFromItsBackToo() {
    world.add(TestMeshes.quad(true, 5, 0, -3, -5, 0, -3, -5, 3, -3, 5, 3, -3));
    motion = MotionRequest.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -2.75, 1e-3);
  }

  @Test
  void alongAWallItKeepsItsTangentialSpeed() {
    world.add(TestMeshes.floor(0, 50), TestMeshes.box(-50, 0, -1, 50, 3, -0.3));
    viewer.turnTo(Viewer.orientation(Math.toRadians(-60), 0, 0));
    motion = MotionRequest.ahead(1);
    NavigationMotion walker = walker();
    run(walker, 1, FRAME);
    double begin = viewer.position().x();
    run(walker, 4, FRAME);
    assertThat(viewer.position().x() - begin)
        .isCloseTo(4 * Math.sin(Math.toRadians(60)), within(1e-4));
    assertThat(viewer.position().z()).isCloseTo(-0.05, within(1e-4));
  }

  @Test
  void aWallOfManyPiecesIsAsSmoothAsOne() {
    world.add(TestMeshes.floor(0, 50));
    for (int i = -20; i < 20; i++) {
      world.add(TestMeshes.box(i, 0, -1, i + 1, 3, -0.3));
    }
    viewer.turnTo(Viewer.orientation(Math.toRadians(-45), 0, 0));
    motion = MotionRequest.ahead(1);
    run(walker(), 5, FRAME);
    assertThat(viewer.position().x()).isCloseTo(5 * Math.sqrt(0.5), within(2e-3));
  }

  @Test
  void noWalkEverLeavesAClosedRoomWithAPillarAndASlantedWall() {
    world.add(TestMeshes.floor(0, 4));
    world.add(
        TestMeshes.quad(true, -3, -1, -3, 3, -1, -3, 3, 4, -3, -3, 4, -3),
        TestMeshes.quad(true, -3, -1, 3, -3, 4, 3, 3, 4, 3, 3, -1, 3),
        TestMeshes.quad(true, -3, -1, -3, -3, 4, -3, -3, 4, 3, -3, -1, 3),
        TestMeshes.quad(true, 3, -1, -3, 3, -1, 3, 3, 4, 3, 3, 4, -3),
        TestMeshes.quad(true, 1, 0, -3, 3, 0, -2.5, 3, 4, -2.5, 1, 4, -3),
        TestMeshes.box(-1.5, 0, -1.5, -0.7, 3, -0.7));
    Random random = new Random(5);
    NavigationMotion walker = walker();
    for (int i = 0; i < 10_000; i++) {
      double dt = i % 10 == 0 ? random.nextDouble() : random.nextDouble() / 30;
      motion =
          new MotionRequest(
              random.nextInt(3) - 1,
              random.nextInt(3) - 1,
              0,
              random.nextDouble() * 4 - 2,
              random.nextDouble() - 0.5,
              0,
              random.nextDouble() * 10);
      run(walker, dt, dt);
      double x = viewer.position().x();
      double z = viewer.position().z();
      assertThat(Math.max(Math.abs(x), Math.abs(z))).isLessThan(2.75 + 1e-4);
      assertThat(Math.max(Math.abs(x + 1.1), Math.abs(z + 1.1))).isGreaterThan(0.4);
      assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-6));
    }
  }

  @Test
  void anAcuteCornerHoldsItWithoutTrembling() {
    world.add(TestMeshes.floor(0, 50));
    world.add(
        TestMeshes.quad(true, -2, 0, 0, 0, 0, -5, 0, 3, -5, -2, 3, 0),
        TestMeshes.quad(true, 2, 0, 0, 0, 0, -5, 0, 3, -5, 2, 3, 0));
    motion = MotionRequest.ahead(1);
    NavigationMotion walker = walker();
    run(walker, 10, FRAME);
    Vector3d rest = new Vector3d(viewer.position());
    assertThat(rest.z).isCloseTo(-5 + 0.25 / Math.sin(Math.atan2(2, 5)), within(0.02));
    run(walker, 1, FRAME);
    assertThat(rest.distance(viewer.position())).isLessThan(1e-3);
  }

  @Test
  void itWalksThroughADoorwayOfEightyCentimetres() {
    world.add(TestMeshes.floor(0, 50));
    world.add(
        TestMeshes.box(-5, 0, -2.2, -0.4, 2.5, -2),
        TestMeshes.box(0.4, 0, -2.2, 5, 2.5, -2),
        TestMeshes.box(-0.4, 2, -2.2, 0.4, 2.5, -2));
    viewer.moveTo(new Vector3d(0.25, 1.6, 0));
    motion = MotionRequest.ahead(1);
    run(walker(), 4, FRAME);
    assertThat(viewer.position().z()).isLessThan(-3.8);
  }

  @Test
  void aDoorwayNarrowerThanItselfHoldsItUp() {
    world.add(TestMeshes.floor(0, 50));
    world.add(TestMeshes.box(-5, 0, -2.2, -0.2, 2.5, -2), TestMeshes.box(0.2, 0, -2.2, 5, 2.5, -2));
    motion = MotionRequest.ahead(1);
    run(walker(), 6, FRAME);
    assertThat(viewer.position().z()).isGreaterThan(-2);
  }

  @Test
  void thePathIsTheSameAtThirtyAndAHundredAndTwentyFramesPerSecond() {
    world.add(TestMeshes.floor(0, 50));
    world.add(
        TestMeshes.box(-2, 0, -20, 2, 0.25, -2),
        TestMeshes.box(-9, 0, -5.2, 9, 3, -5),
        TestMeshes.box(1.5, 0, -5, 1.7, 3, 3));
    motion = new MotionRequest(1, 0.2, 0, -0.3, 0, 0, 1.5);
    NavigationMotion walker = walker();
    Vector3d end = new Vector3d();
    for (double rate : new double[] {120, 30}) {
      viewer.moveTo(new Vector3d(0, 1.6, 0));
      viewer.turnTo(Viewer.orientation(0, 0, 0));
      run(walker, 4, 1 / rate);
      if (rate == 120) {
        end.set(viewer.position());
      }
    }
    assertThat(viewer.position().distance(end)).isLessThan(0.01);
  }

  @Test
  void theSameInputGivesExactlyTheSamePath() {
    world.add(TestMeshes.floor(0, 50), TestMeshes.box(-5, 0, -3, 5, 3, -2));
    motion = new MotionRequest(1, 0.3, 0, 0.5, 0, 0, 1);
    run(walker(), 5, FRAME);
    Vector3d first = new Vector3d(viewer.position());
    viewer.moveTo(new Vector3d(0, 1.6, 0));
    viewer.turnTo(Viewer.orientation(0, 0, 0));
    run(walker(), 5, FRAME);
    assertThat(first.equals(viewer.position())).isTrue();
  }

  @Test
  void aViewpointInAScaledAndTiltedPlaceHasItsOwnSizeSpeedAndUp() {
    Matrix4d place = new Matrix4d().rotateZ(Math.PI / 2).scale(2);
    // Up is now -X of the world: the ground is a wall of the world at x = 0.
    world.add(TestMeshes.quad(true, 0, -50, -50, 0, -50, 50, 0, 50, 50, 0, 50, -50));
    NavigationMotion walker = walker();
    walker.use(SMALL_STEPS, ViewpointFrame.of(place));
    viewer.moveTo(new Vector3d(-5, 0, 0));
    viewer.turnTo(walkerUpright(place));
    motion = MotionRequest.ahead(1);
    run(walker, 3, FRAME);
    assertAt(-3.2, 0, -6, 1e-6);
  }
}
