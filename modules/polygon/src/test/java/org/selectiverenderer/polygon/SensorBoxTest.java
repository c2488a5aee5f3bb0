package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SensorBoxTest {
  private static final float[] ORIGIN = {0, 0, 0};
  private static final float[] SIZE = {2, 2, 2};

  private static SensorBox box(Matrix4dc world) {
    return SensorBox.of(ORIGIN, SIZE, world).orElseThrow();
  }

  private static SensorBox at(double x, double y, double z) {
    return box(new Matrix4d().translation(x, y, z));
  }

  @Test
  void boxesShareAPlaceIfTheyOverlapNotIfTheyTouch() {
    assertThat(SensorBox.share(List.of(at(0, 0, 0), at(1.9, 0, 0)))).isTrue();
    assertThat(SensorBox.share(List.of(at(0, 0, 0), at(2, 0, 0)))).isFalse();
    assertThat(SensorBox.share(List.of(at(0, 0, 0), at(2.1, 0, 0)))).isFalse();
    assertThat(SensorBox.share(List.of(at(0, 0, 0), at(0, 0, 0)))).isTrue();
  }

  @Test
  void aBoxWithinAnotherSharesItsPlace() {
    SensorBox small = box(new Matrix4d().translation(0.3, 0.2, 0.1).scale(0.1));

    assertThat(SensorBox.share(List.of(at(0, 0, 0), small))).isTrue();
  }

  /** A bar turned by 45 degrees whose corner region only its axis-aligned bounds reach. */
  @Test
  void turnedBoxesAreNotTheirBounds() {
    SensorBox bar = box(new Matrix4d().rotateZ(Math.toRadians(45)).scale(5, 0.2, 1));

    assertThat(SensorBox.share(List.of(bar, at(3, -3, 0)))).isFalse();
    assertThat(SensorBox.share(List.of(bar, at(3, 3, 0)))).isTrue();
  }

  /** Scaled unequally after a turn, a box leans; only then does it reach the other one. */
  @Test
  void unequalScaleAboveATurnMakesBoxesLean() {
    SensorBox other = at(5, 2.2, 0);

    assertThat(SensorBox.share(List.of(box(lean(1)), other))).isFalse();
    assertThat(SensorBox.share(List.of(box(lean(4)), other))).isTrue();
  }

  private static Matrix4d lean(double scale) {
    return new Matrix4d().scale(scale, 1, 1).rotateZ(Math.toRadians(45)).scale(2, 0.1, 1);
  }

  /** Three bars that form a triangle: each two meet, all three nowhere. */
  @Test
  void boxesThatMeetInPairsNeedNotAllMeet() {
    List<SensorBox> bars = List.of(bar(0), bar(120), bar(240));

    assertThat(SensorBox.share(bars.subList(0, 2))).isTrue();
    assertThat(SensorBox.share(bars.subList(1, 3))).isTrue();
    assertThat(SensorBox.share(List.of(bars.get(0), bars.get(2)))).isTrue();
    assertThat(SensorBox.share(bars)).isFalse();
  }

  private static SensorBox bar(double degrees) {
    return box(new Matrix4d().rotateZ(Math.toRadians(degrees)).translate(0, 2, 0).scale(6, 0.2, 1));
  }

  @Test
  void whatHasNoInsideIsNoBox() {
    assertThat(SensorBox.of(ORIGIN, new float[] {2, 0, 2}, new Matrix4d())).isEmpty();
    assertThat(SensorBox.of(ORIGIN, SIZE, new Matrix4d().scale(1, 0, 1))).isEmpty();
  }

  /** Points that are in both boxes, drawn at random, against the answer. */
  @Test
  void agreesWithPointsDrawnAtRandom() {
    Random random = new Random(5);
    int overlapping = 0;
    for (int round = 0; round < 300; round++) {
      Matrix4d a = matrix(random);
      Matrix4d b = matrix(random);
      boolean found = false;
      Matrix4d fromB = b.invert(new Matrix4d());
      for (int i = 0; i < 2000 && !found; i++) {
        Vector3d p = a.transformPosition(point(random));
        fromB.transformPosition(p);
        found = Math.abs(p.x) < 0.999 && Math.abs(p.y) < 0.999 && Math.abs(p.z) < 0.999;
      }
      boolean share = SensorBox.share(List.of(box(a), box(b)));
      if (found) {
        assertThat(share).as("round %d", round).isTrue();
        overlapping++;
      }
    }
    assertThat(overlapping).isBetween(50, 290);
  }

  /** Boxes that a plane parts share nothing, whatever their form. */
  @Test
  void boxesOnTwoSidesOfAPlaneShareNothing() {
    Random random = new Random(6);
    for (int round = 0; round < 300; round++) {
      Matrix4d turn = new Matrix4d().rotateXYZ(random.nextDouble(), random.nextDouble(), 1);
      SensorBox left = box(turn.translate(-1.0001, 0, 0, new Matrix4d()));
      double y = random.nextDouble() - 0.5;
      SensorBox right = box(turn.translate(1.0001, y, 0, new Matrix4d()).scale(1, 3, 0.5));

      assertThat(SensorBox.share(List.of(left, right))).isFalse();
    }
  }

  private static Vector3d point(Random random) {
    return new Vector3d(
        2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
  }

  private static Matrix4d matrix(Random random) {
    return new Matrix4d()
        .translate(point(random).mul(2))
        .scale(0.3 + random.nextDouble(), 0.3 + random.nextDouble(), 0.3 + random.nextDouble())
        .rotateXYZ(random.nextDouble() * 6, random.nextDouble() * 6, random.nextDouble() * 6)
        .scale(0.3 + random.nextDouble(), 0.3 + random.nextDouble(), 0.3 + random.nextDouble());
  }
}
