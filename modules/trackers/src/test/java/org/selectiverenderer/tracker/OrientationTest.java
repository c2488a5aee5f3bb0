package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class OrientationTest {
  private static final Vector3D FRONT = new Vector3D(0, 0, -1);

  @Test
  void yawTurnsToTheLeftPitchUpAndRollTiltsToTheLeftShoulder() {
    assertThat(distance(look(90, 0, 0), -1, 0, 0)).isLessThan(1e-12);
    assertThat(distance(look(0, 90, 0), 0, 1, 0)).isLessThan(1e-12);
    Vector3D up = new Orientation(0, 0, 90).rotation().applyTo(new Vector3D(0, 1, 0));
    assertThat(distance(up, -1, 0, 0)).isLessThan(1e-12);
  }

  @Test
  void pitchIsAboutTheTurnedHeadsOwnAxis() {
    // To the left, then up: still to the left of straight ahead, and up.
    assertThat(distance(look(90, 45, 0), -Math.sqrt(0.5), Math.sqrt(0.5), 0)).isLessThan(1e-12);
  }

  @Test
  void whatRunsPerRecordIsWhatCommonsMathSays() {
    Random random = new Random(1);
    PoseSample sample = new PoseSample();
    for (int i = 0; i < 10_000; i++) {
      Orientation angles =
          new Orientation(
              random.nextDouble(-180, 180),
              random.nextDouble(-180, 180),
              random.nextDouble(-180, 180));
      sample.turn(angles.yaw(), angles.pitch(), angles.roll());
      assertThat(apart(sample, angles.rotation())).isLessThan(1e-9);
    }
  }

  @Test
  void anglesComeBackFromARotation() {
    Random random = new Random(2);
    for (int i = 0; i < 10_000; i++) {
      Orientation angles =
          new Orientation(
              random.nextDouble(-180, 180),
              random.nextDouble(-89.9, 89.9),
              random.nextDouble(-180, 180));
      Orientation back = Orientation.of(angles.rotation());
      assertThat(back.yaw()).isCloseTo(angles.yaw(), within(1e-6));
      assertThat(back.pitch()).isCloseTo(angles.pitch(), within(1e-6));
      assertThat(back.roll()).isCloseTo(angles.roll(), within(1e-6));
    }
  }

  @Test
  void straightUpAndDownTheRotationIsKeptThoughTheAnglesAreNot() {
    for (double pitch : new double[] {90, -90}) {
      Rotation rotation = new Orientation(30, pitch, 20).rotation();
      Orientation back = Orientation.of(rotation);
      assertThat(back.roll()).isZero();
      assertThat(Rotation.distance(rotation, back.rotation())).isLessThan(1e-6);
    }
  }

  @Test
  void anglesAreBroughtToHalfATurn() {
    PoseSample sample = new PoseSample();
    sample.turn(270, -190, 360);
    assertThat(sample.orientation()).isEqualTo(new Orientation(-90, 170, 0));
    sample.turn(180, -180, 0);
    assertThat(sample.orientation()).isEqualTo(new Orientation(180, -180, 0));
  }

  private static Vector3D look(double yaw, double pitch, double roll) {
    return new Orientation(yaw, pitch, roll).rotation().applyTo(FRONT);
  }

  private static double distance(Vector3D vector, double x, double y, double z) {
    return vector.distance(new Vector3D(x, y, z));
  }

  /** How far the two take the three axes apart. */
  private static double apart(PoseSample sample, Rotation rotation) {
    Quaterniond quaternion = sample.orientation(new Quaterniond());
    double apart = 0;
    for (Vector3D axis : new Vector3D[] {Vector3D.PLUS_I, Vector3D.PLUS_J, Vector3D.PLUS_K}) {
      Vector3d ours = quaternion.transform(new Vector3d(axis.getX(), axis.getY(), axis.getZ()));
      apart += distance(rotation.applyTo(axis), ours.x, ours.y, ours.z);
    }
    return apart;
  }
}
