package org.selectiverenderer.browser.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.geometry.mesh.TestMeshes;

/** Looking, flying, examining, and no navigation at all. */
class NavigationModesTest extends NavigationMotionTestCase {
  @Test
  void looksNoHigherThanStraightUpAndStaysUpright() {
    world.add(TestMeshes.floor(0, 50));
    viewer.turnTo(Viewer.orientation(1, 0.2, 0.7));
    motion = new MotionRequest(0, 0, 0, 0, 0.01, 0.3, 1);
    run(walker(), 20 * FRAME, FRAME);
    Vector3d front = viewer.orientation().transform(new Vector3d(0, 0, -1));
    Vector3d right = viewer.orientation().transform(new Vector3d(1, 0, 0));
    assertThat(front.y).isCloseTo(1, within(1e-12));
    assertThat(right.y).isCloseTo(0, within(1e-12));
    assertThat(Math.atan2(-right.z, right.x)).isCloseTo(1.2, within(0.05));
  }

  @Test
  void aWalkerWhoLooksUpStillWalksLevel() {
    world.add(TestMeshes.floor(0, 50));
    viewer.turnTo(Viewer.orientation(0, 1.2, 0));
    motion = MotionRequest.ahead(1);
    run(walker(), 1, FRAME);
    assertAt(0, 1.6, -1, 1e-6);
  }

  @Test
  void flyingGoesWhereItLooksAndStopsAtEverything() {
    world.add(TestMeshes.floor(0, 50));
    NavigationMotion walker = walker();
    walker.mode(NavigationMode.FLY);
    viewer.moveTo(new Vector3d(0, 5, 0));
    viewer.turnTo(Viewer.orientation(0, -Math.PI / 6, 0));
    motion = MotionRequest.ahead(1);
    run(walker, 2, FRAME);
    assertAt(0, 4, -Math.sqrt(3), 1e-6);
    run(walker, 20, 1);
    assertAt(0, 0.25, -22 * Math.sqrt(0.75), 0.01);
  }

  @Test
  void noFlightEverLeavesAClosedBox() {
    world.add(TestMeshes.box(-2, -2, -2, 2, 2, 2));
    NavigationMotion walker = walker();
    walker.mode(NavigationMode.FLY);
    viewer.moveTo(new Vector3d());
    Random random = new Random(6);
    for (int i = 0; i < 3000; i++) {
      double dt = i % 10 == 0 ? random.nextDouble() : random.nextDouble() / 30;
      double rise = random.nextInt(3) - 1;
      motion = new MotionRequest(1, 0, rise, 0, random.nextGaussian(), random.nextGaussian(), 10);
      run(walker, dt, dt);
      assertThat(viewer.position().get(viewer.position().maxComponent()))
          .isBetween(-1.75 - 1e-4, 1.75 + 1e-4);
    }
  }

  @Test
  void examiningTurnsAboutThePivotAtTheSameDistance() {
    NavigationMotion walker = walker();
    walker.mode(NavigationMode.EXAMINE);
    Vector3d pivot = new Vector3d(0, 1.6, -4);
    walker.pivot(pivot);
    motion = new MotionRequest(0, 0, 0, 0, Math.PI / 2, 0, 1);
    run(walker, FRAME, FRAME);
    assertAt(4, 1.6, -4, 1e-9);
    assertThat(viewer.orientation().transform(new Vector3d(0, 0, -1)).distance(-1, 0, 0))
        .isLessThan(1e-9);
    motion = MotionRequest.ahead(1);
    run(walker, 20, FRAME);
    assertThat(viewer.position().distance(pivot)).isBetween(1e-12, 0.01);
  }

  @Test
  void withoutNavigationNothingMoves() {
    world.add(TestMeshes.floor(-10, 50));
    NavigationMotion walker = walker();
    walker.mode(NavigationMode.NONE);
    motion = MotionRequest.ahead(1);
    run(walker, 1, FRAME);
    assertAt(0, 1.6, 0, 1e-12);
  }
}
