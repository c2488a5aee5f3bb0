package org.selectiverenderer.runtime.walk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.runtime.collide.Meshes;
import org.selectiverenderer.runtime.collide.TestWorld;
import org.selectiverenderer.runtime.viewer.NavigationFrame;
import org.selectiverenderer.runtime.viewer.Viewer;

/** A walker 1.6 m tall, 0.25 m wide to either side, who steps over 0.3 m, at 1 m/s. */
class WalkerTest {
  private static final double FRAME = 1.0 / 60;
  private static final Navigation SMALL_STEPS =
      new Navigation(List.of(NavigationMode.WALK), 0.25, 1.6, 0.3, 1);

  private final TestWorld world = new TestWorld();
  private final Viewer viewer = new Viewer();
  private Motion motion = Motion.NONE;
  private double time;

  @BeforeEach
  void beginAtTheOrigin() {
    viewer.moveTo(new Vector3d(0, 1.6, 0));
  }

  private Walker walker() {
    Walker walker = new Walker(world.colliders(), dt -> motion);
    walker.use(SMALL_STEPS, NavigationFrame.WORLD);
    return walker;
  }

  private void run(Walker walker, double seconds, double dt) {
    for (int i = 0; i < Math.round(seconds / dt); i++) {
      time += dt;
      walker.move(viewer, time, dt);
    }
  }

  private void assertAt(double x, double y, double z, double tolerance) {
    assertThat(viewer.position().distance(x, y, z))
        .as("distance of %s from (%s, %s, %s)", viewer.position(), x, y, z)
        .isLessThan(tolerance);
  }

  @Test
  void walksAheadAtTheSpeedOfTheNavigationInfo() {
    world.add(Meshes.floor(0, 50));
    motion = Motion.ahead(1);
    run(walker(), 3, FRAME);
    assertAt(0, 1.6, -3, 1e-6);
  }

  @Test
  void diagonallyItIsNoFaster() {
    world.add(Meshes.floor(0, 50));
    motion = new Motion(1, 1, 0, 0, 0, 0, 2);
    run(walker(), 1, FRAME);
    assertAt(Math.sqrt(2), 1.6, -Math.sqrt(2), 1e-6);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0 / 240, 1.0 / 60, 0.1, 1})
  void aWallStopsItAtTheCollisionDistance(double dt) {
    world.add(Meshes.floor(0, 50), Meshes.box(-5, 0, -3.001, 5, 3, -3));
    motion = new Motion(1, 0, 0, 0, 0, 0, 20);
    run(walker(), 5, dt);
    assertAt(0, 1.6, -2.75, 1e-3);
  }

  @Test
  void aWallIsSolidFromItsBackToo() {
    world.add(Meshes.quad(true, 5, 0, -3, -5, 0, -3, -5, 3, -3, 5, 3, -3));
    motion = Motion.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -2.75, 1e-3);
  }

  @Test
  void alongAWallItKeepsItsTangentialSpeed() {
    world.add(Meshes.floor(0, 50), Meshes.box(-50, 0, -1, 50, 3, -0.3));
    viewer.turnTo(Viewer.orientation(Math.toRadians(-60), 0, 0));
    motion = Motion.ahead(1);
    Walker walker = walker();
    run(walker, 1, FRAME);
    double begin = viewer.position().x();
    run(walker, 4, FRAME);
    assertThat(viewer.position().x() - begin)
        .isCloseTo(4 * Math.sin(Math.toRadians(60)), within(1e-4));
    assertThat(viewer.position().z()).isCloseTo(-0.05, within(1e-4));
  }

  @Test
  void aWallOfManyPiecesIsAsSmoothAsOne() {
    world.add(Meshes.floor(0, 50));
    for (int i = -20; i < 20; i++) {
      world.add(Meshes.box(i, 0, -1, i + 1, 3, -0.3));
    }
    viewer.turnTo(Viewer.orientation(Math.toRadians(-45), 0, 0));
    motion = Motion.ahead(1);
    run(walker(), 5, FRAME);
    assertThat(viewer.position().x()).isCloseTo(5 * Math.sqrt(0.5), within(2e-3));
  }

  @Test
  void noWalkEverLeavesAClosedRoomWithAPillarAndASlantedWall() {
    world.add(Meshes.floor(0, 4));
    world.add(
        Meshes.quad(true, -3, -1, -3, 3, -1, -3, 3, 4, -3, -3, 4, -3),
        Meshes.quad(true, -3, -1, 3, -3, 4, 3, 3, 4, 3, 3, -1, 3),
        Meshes.quad(true, -3, -1, -3, -3, 4, -3, -3, 4, 3, -3, -1, 3),
        Meshes.quad(true, 3, -1, -3, 3, -1, 3, 3, 4, 3, 3, 4, -3),
        Meshes.quad(true, 1, 0, -3, 3, 0, -2.5, 3, 4, -2.5, 1, 4, -3),
        Meshes.box(-1.5, 0, -1.5, -0.7, 3, -0.7));
    Random random = new Random(5);
    Walker walker = walker();
    for (int i = 0; i < 10_000; i++) {
      double dt = i % 10 == 0 ? random.nextDouble() : random.nextDouble() / 30;
      motion =
          new Motion(
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
    world.add(Meshes.floor(0, 50));
    world.add(
        Meshes.quad(true, -2, 0, 0, 0, 0, -5, 0, 3, -5, -2, 3, 0),
        Meshes.quad(true, 2, 0, 0, 0, 0, -5, 0, 3, -5, 2, 3, 0));
    motion = Motion.ahead(1);
    Walker walker = walker();
    run(walker, 10, FRAME);
    Vector3d rest = new Vector3d(viewer.position());
    assertThat(rest.z).isCloseTo(-5 + 0.25 / Math.sin(Math.atan2(2, 5)), within(0.02));
    run(walker, 1, FRAME);
    assertThat(rest.distance(viewer.position())).isLessThan(1e-3);
  }

  @Test
  void itWalksThroughADoorwayOfEightyCentimetres() {
    world.add(Meshes.floor(0, 50));
    world.add(
        Meshes.box(-5, 0, -2.2, -0.4, 2.5, -2),
        Meshes.box(0.4, 0, -2.2, 5, 2.5, -2),
        Meshes.box(-0.4, 2, -2.2, 0.4, 2.5, -2));
    viewer.moveTo(new Vector3d(0.25, 1.6, 0));
    motion = Motion.ahead(1);
    run(walker(), 4, FRAME);
    assertThat(viewer.position().z()).isLessThan(-3.8);
  }

  @Test
  void aDoorwayNarrowerThanItselfHoldsItUp() {
    world.add(Meshes.floor(0, 50));
    world.add(Meshes.box(-5, 0, -2.2, -0.2, 2.5, -2), Meshes.box(0.2, 0, -2.2, 5, 2.5, -2));
    motion = Motion.ahead(1);
    run(walker(), 6, FRAME);
    assertThat(viewer.position().z()).isGreaterThan(-2);
  }

  @Test
  void stepsAreClimbedUpToTheStepHeightAndNotAbove() {
    world.add(Meshes.floor(0, 50));
    for (int i = 0; i < 5; i++) {
      world.add(Meshes.box(-2, 0, -20, 2, 0.3 * (i + 1), -2 - 0.4 * i));
    }
    world.add(Meshes.box(-2, 0, -20, 2, 1.81, -6));
    motion = Motion.ahead(1);
    run(walker(), 10, FRAME);
    assertAt(0, 1.5 + 1.6, -5.75, 1e-3);
  }

  @Test
  void rampsAreWalkedUpAndDownWithTheEyeAtItsHeight() {
    world.add(Meshes.floor(0, 50));
    world.add(
        Meshes.quad(true, -2, 0, -1, 2, 0, -1, 2, 3, -5, -2, 3, -5),
        Meshes.quad(true, -2, 3, -5, 2, 3, -5, 2, 0, -9, -2, 0, -9));
    motion = Motion.ahead(1);
    Walker walker = walker();
    for (int i = 0; i < 600; i++) {
      run(walker, FRAME, FRAME);
      double ground = Math.max(0, 3 - 0.75 * Math.abs(viewer.position().z() + 5));
      assertThat(viewer.position().y()).isCloseTo(ground + 1.6, within(1e-3));
    }
    assertThat(viewer.position().z()).isCloseTo(-10, within(0.05));
  }

  @Test
  void withoutStepHeightARampIsStillGround() {
    world.add(Meshes.floor(0, 50), Meshes.quad(true, -2, 0, -1, 2, 0, -1, 2, 3, -5, -2, 3, -5));
    Walker walker = walker();
    walker.use(
        new Navigation(List.of(NavigationMode.WALK), 0.25, 1.6, 0, 1), NavigationFrame.WORLD);
    motion = Motion.ahead(1);
    run(walker, 3, FRAME);
    assertAt(0, 1.6 + 1.5, -3, 0.01);
  }

  @Test
  void fallingFollowsGravityAndEndsAtTheEyesHeight() {
    world.add(Meshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 11.6, 0));
    Walker walker = walker();
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(11.6 - 9.81 / 2, within(1e-6));
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
    run(walker, 1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void aLongFrameDoesNotFallThroughTheGround() {
    world.add(Meshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 30, 0));
    run(walker(), 10, 1);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void whereNoGroundIsNothingFalls() {
    world.add(Meshes.floor(0, 2));
    motion = Motion.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -5, 1e-6);
  }

  @Test
  void oneWhoBeginsInTheGroundStandsUp() {
    world.add(Meshes.floor(0, 50));
    viewer.moveTo(new Vector3d(0, 0.4, 0));
    run(walker(), 0.1, FRAME);
    assertThat(viewer.position().y()).isCloseTo(1.6, within(1e-9));
  }

  @Test
  void underALowCeilingItDoesNotStepUp() {
    world.add(Meshes.floor(0, 50));
    world.add(Meshes.box(-2, 0, -9, 2, 0.3, -2), Meshes.box(-2, 1.8, -9, 2, 2, -2.1));
    motion = Motion.ahead(1);
    run(walker(), 5, FRAME);
    assertThat(viewer.position().z()).isGreaterThan(-2.2);
    assertThat(viewer.position().y()).isLessThan(1.8);
  }

  @Test
  void aTableThatIsOnlyATopHoldsItUp() {
    world.add(Meshes.floor(0, 50), Meshes.quad(false, -1, 1, -2, 1, 1, -2, 1, 1, -4, -1, 1, -4));
    motion = Motion.ahead(1);
    run(walker(), 5, FRAME);
    assertAt(0, 1.6, -1.75, 1e-3);
  }

  @Test
  void thePathIsTheSameAtThirtyAndAHundredAndTwentyFramesPerSecond() {
    world.add(Meshes.floor(0, 50));
    world.add(
        Meshes.box(-2, 0, -20, 2, 0.25, -2),
        Meshes.box(-9, 0, -5.2, 9, 3, -5),
        Meshes.box(1.5, 0, -5, 1.7, 3, 3));
    motion = new Motion(1, 0.2, 0, -0.3, 0, 0, 1.5);
    Walker walker = walker();
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
    world.add(Meshes.floor(0, 50), Meshes.box(-5, 0, -3, 5, 3, -2));
    motion = new Motion(1, 0.3, 0, 0.5, 0, 0, 1);
    run(walker(), 5, FRAME);
    Vector3d first = new Vector3d(viewer.position());
    viewer.moveTo(new Vector3d(0, 1.6, 0));
    viewer.turnTo(Viewer.orientation(0, 0, 0));
    run(walker(), 5, FRAME);
    assertThat(first.equals(viewer.position())).isTrue();
  }

  @Test
  void looksNoHigherThanStraightUpAndStaysUpright() {
    world.add(Meshes.floor(0, 50));
    viewer.turnTo(Viewer.orientation(1, 0.2, 0.7));
    motion = new Motion(0, 0, 0, 0, 0.01, 0.3, 1);
    run(walker(), 20 * FRAME, FRAME);
    Vector3d front = viewer.orientation().transform(new Vector3d(0, 0, -1));
    Vector3d right = viewer.orientation().transform(new Vector3d(1, 0, 0));
    assertThat(front.y).isCloseTo(1, within(1e-12));
    assertThat(right.y).isCloseTo(0, within(1e-12));
    assertThat(Math.atan2(-right.z, right.x)).isCloseTo(1.2, within(0.05));
  }

  @Test
  void aWalkerWhoLooksUpStillWalksLevel() {
    world.add(Meshes.floor(0, 50));
    viewer.turnTo(Viewer.orientation(0, 1.2, 0));
    motion = Motion.ahead(1);
    run(walker(), 1, FRAME);
    assertAt(0, 1.6, -1, 1e-6);
  }

  @Test
  void aViewpointInAScaledAndTiltedPlaceHasItsOwnSizeSpeedAndUp() {
    Matrix4d place = new Matrix4d().rotateZ(Math.PI / 2).scale(2);
    // Up is now -X of the world: the ground is a wall of the world at x = 0.
    world.add(Meshes.quad(true, 0, -50, -50, 0, -50, 50, 0, 50, 50, 0, 50, -50));
    Walker walker = walker();
    walker.use(SMALL_STEPS, NavigationFrame.of(place));
    viewer.moveTo(new Vector3d(-5, 0, 0));
    viewer.turnTo(walkerUpright(place));
    motion = Motion.ahead(1);
    run(walker, 3, FRAME);
    assertAt(-3.2, 0, -6, 1e-6);
  }

  private static Quaterniond walkerUpright(Matrix4d place) {
    return new Quaterniond(NavigationFrame.of(place).upright());
  }

  @Test
  void withoutCollisionsWallsAreNoObstacleButTheGroundIsGround() {
    world.add(Meshes.floor(0, 50), Meshes.box(-5, 0, -3.2, 5, 3, -3));
    Walker walker = walker();
    walker.collisions(false);
    motion = Motion.ahead(1);
    run(walker, 5, FRAME);
    assertAt(0, 1.6, -5, 1e-6);
  }

  @Test
  void flyingGoesWhereItLooksAndStopsAtEverything() {
    world.add(Meshes.floor(0, 50));
    Walker walker = walker();
    walker.mode(NavigationMode.FLY);
    viewer.moveTo(new Vector3d(0, 5, 0));
    viewer.turnTo(Viewer.orientation(0, -Math.PI / 6, 0));
    motion = Motion.ahead(1);
    run(walker, 2, FRAME);
    assertAt(0, 4, -Math.sqrt(3), 1e-6);
    run(walker, 20, 1);
    assertAt(0, 0.25, -22 * Math.sqrt(0.75), 0.01);
  }

  @Test
  void noFlightEverLeavesAClosedBox() {
    world.add(Meshes.box(-2, -2, -2, 2, 2, 2));
    Walker walker = walker();
    walker.mode(NavigationMode.FLY);
    viewer.moveTo(new Vector3d());
    Random random = new Random(6);
    for (int i = 0; i < 3000; i++) {
      double dt = i % 10 == 0 ? random.nextDouble() : random.nextDouble() / 30;
      double rise = random.nextInt(3) - 1;
      motion = new Motion(1, 0, rise, 0, random.nextGaussian(), random.nextGaussian(), 10);
      run(walker, dt, dt);
      assertThat(viewer.position().get(viewer.position().maxComponent()))
          .isBetween(-1.75 - 1e-4, 1.75 + 1e-4);
    }
  }

  @Test
  void examiningTurnsAboutThePivotAtTheSameDistance() {
    Walker walker = walker();
    walker.mode(NavigationMode.EXAMINE);
    Vector3d pivot = new Vector3d(0, 1.6, -4);
    walker.pivot(pivot);
    motion = new Motion(0, 0, 0, 0, Math.PI / 2, 0, 1);
    run(walker, FRAME, FRAME);
    assertAt(4, 1.6, -4, 1e-9);
    assertThat(viewer.orientation().transform(new Vector3d(0, 0, -1)).distance(-1, 0, 0))
        .isLessThan(1e-9);
    motion = Motion.ahead(1);
    run(walker, 20, FRAME);
    assertThat(viewer.position().distance(pivot)).isBetween(1e-12, 0.01);
  }

  @Test
  void withoutNavigationNothingMoves() {
    world.add(Meshes.floor(-10, 50));
    Walker walker = walker();
    walker.mode(NavigationMode.NONE);
    motion = Motion.ahead(1);
    run(walker, 1, FRAME);
    assertAt(0, 1.6, 0, 1e-12);
  }
}
