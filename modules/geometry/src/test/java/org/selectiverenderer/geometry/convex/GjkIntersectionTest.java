package org.selectiverenderer.geometry.convex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Bodies meet where a formula of their own says so. */
class GjkIntersectionTest {
  /** Nearer to touching than this, rounding decides. */
  private static final double UNSURE = 1e-6;

  /** As often as this each must have been tried, lest one answer to all would do. */
  private static final int SOME = 9;

  private final Random random = new Random(38);
  private int met;
  private int parted;

  @AfterEach
  void bothWereTried() {
    assertThat(met).as("bodies that meet").isGreaterThanOrEqualTo(SOME);
    assertThat(parted).as("bodies that do not").isGreaterThanOrEqualTo(SOME);
  }

  private Vector3d somewhere(double reach) {
    return new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .mul(reach);
  }

  private static ConvexShape at(ConvexShape body, Vector3d place) {
    return (direction, out) -> body.farthest(direction, out).add(place);
  }

  private void check(ConvexShape one, ConvexShape two, double apart, String what) {
    if (Math.abs(apart) > UNSURE) {
      met += apart < 0 ? 1 : 0;
      parted += apart > 0 ? 1 : 0;
      assertThat(GjkIntersection.of(one, two)).as(what).isEqualTo(apart < 0);
      assertThat(GjkIntersection.of(two, one)).as(what).isEqualTo(apart < 0);
    }
  }

  @Test
  void boxes() {
    for (int i = 0; i < 2000; i++) {
      Vector3d p = somewhere(1.5);
      double apart = Math.max(Math.abs(p.x) - 1.5, Math.max(Math.abs(p.y) - 2, Math.abs(p.z) - 1));
      check(ConvexShape.box(2, 2, 1), at(ConvexShape.box(1, 2, 1), p), apart, "boxes " + p);
    }
  }

  @Test
  void spheres() {
    for (int i = 0; i < 2000; i++) {
      Vector3d p = somewhere(1.5);
      check(
          ConvexShape.sphere(1), at(ConvexShape.sphere(1.5), p), p.length() - 2.5, "spheres " + p);
    }
  }

  @Test
  void pointsAndACone() {
    for (int i = 0; i < 2000; i++) {
      Vector3d p = somewhere(1);
      double inWall = Math.hypot(p.x, p.z) - (1 - p.y / 2);
      double apart = Math.max(Math.max(p.y - 2, -2 - p.y), inWall);
      check(ConvexShape.cone(2, 4), ConvexShape.hull(p.x, p.y, p.z), apart, "cone " + p);
    }
  }

  @Test
  void pointsAndACylinder() {
    for (int i = 0; i < 2000; i++) {
      Vector3d p = somewhere(1);
      double apart = Math.max(Math.hypot(p.x, p.z) - 1, Math.abs(p.y) - 1.5);
      check(ConvexShape.cylinder(1, 3), ConvexShape.hull(p.x, p.y, p.z), apart, "cylinder " + p);
    }
  }

  @Test
  void aBallAndATriangleThatIsNearestByItsFace() {
    ConvexShape triangle = ConvexShape.hull(-5, 0, -5, 5, 0, -5, 0, 0, 5);
    for (double y = -1.45; y < 1.5; y += 0.1) {
      check(
          at(ConvexShape.sphere(1), new Vector3d(0, y, 0)), triangle, Math.abs(y) - 1, "ball " + y);
    }
  }
}
