package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.RotationOrder;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.junit.jupiter.api.Test;

/** Thesis Fig 50, worked out by hand from the listing. */
class ThesisOrientationTest {
  @Test
  void allAnglesZeroIsTheAxisThatTheListingSets() {
    assertThat(ThesisOrientation.of(0, 0, 0)).containsExactly(1, 0, 0, 0);
  }

  @Test
  void quarterTurns() {
    // c = s = sqrt(1/2) where turned: w = x = y = z = 1/2 for the first two, angle 2 acos(1/2).
    double third = 1 / Math.sqrt(3);
    assertAxisAngle(ThesisOrientation.of(90, 90, 0), third, third, third, 2 * Math.PI / 3);
    assertAxisAngle(ThesisOrientation.of(90, 0, 90), third, third, -third, 2 * Math.PI / 3);
    assertAxisAngle(ThesisOrientation.of(90, 0, 0), 0, 1, 0, Math.PI / 2);
    assertAxisAngle(ThesisOrientation.of(0, 90, 0), 0, 0, 1, Math.PI / 2);
    assertAxisAngle(ThesisOrientation.of(0, 0, 90), 1, 0, 0, Math.PI / 2);
    // All three: w = 1/4 sqrt 2 - 1/4 sqrt 2 = 0, x = y = sqrt(1/2), z = 0.
    double half = Math.sqrt(0.5);
    assertAxisAngle(ThesisOrientation.of(90, 90, 90), half, half, 0, Math.PI);
  }

  @Test
  void isTheOrderYzx() {
    Random random = new Random(3);
    for (int i = 0; i < 1_000; i++) {
      double heading = random.nextDouble(-180, 180);
      double attitude = random.nextDouble(-180, 180);
      double bank = random.nextDouble(-180, 180);
      Rotation expected =
          new Rotation(
              RotationOrder.YZX,
              RotationConvention.VECTOR_OPERATOR,
              Math.toRadians(heading),
              Math.toRadians(attitude),
              Math.toRadians(bank));
      assertThat(Rotation.distance(rotation(heading, attitude, bank), expected)).isLessThan(1e-6);
    }
  }

  @Test
  void agreesWithOursForTheHeadingAndTakesANodForATilt() {
    assertThat(Rotation.distance(rotation(40, 0, 0), new Orientation(40, 0, 0).rotation()))
        .isLessThan(1e-6);
    // A viewer who looks along -Z and nods goes on looking straight ahead.
    Vector3D front = rotation(0, 30, 0).applyTo(new Vector3D(0, 0, -1));
    assertThat(front.getY()).isCloseTo(0, within(1e-12));
    assertThat(Rotation.distance(rotation(0, 30, 0), new Orientation(0, 0, 30).rotation()))
        .isLessThan(1e-6);
  }

  private static Rotation rotation(double heading, double attitude, double bank) {
    double[] turn = ThesisOrientation.of(heading, attitude, bank);
    return new Rotation(
        new Vector3D(turn[0], turn[1], turn[2]), turn[3], RotationConvention.VECTOR_OPERATOR);
  }

  private static void assertAxisAngle(double[] turn, double... expected) {
    assertThat(turn).containsExactly(expected, within(1e-9));
  }
}
