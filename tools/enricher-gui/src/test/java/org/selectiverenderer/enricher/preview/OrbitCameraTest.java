package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.geometry.BoundingBox;

class OrbitCameraTest {
  private final OrbitCamera orbit = new OrbitCamera();

  OrbitCameraTest() {
    orbit.place(new Pose(new Vector3d(0, 0, 10), new Quaterniond(), Math.PI / 4), 10);
  }

  private Vector3d position() {
    return new Vector3d(orbit.pose().position());
  }

  private Vector3d forward() {
    return orbit.pose().orientation().transform(new Vector3d(0, 0, -1));
  }

  @Test
  void aQuarterTurnLooksAtThePointFromTheSide() {
    orbit.turn(Math.PI / 2, 0);
    assertThat(position().distance(10, 0, 0)).isLessThan(1e-9);
    assertThat(forward().distance(-1, 0, 0)).isLessThan(1e-9);
  }

  @Test
  void theEyeStaysUprightOverThePole() {
    for (int i = 0; i < 50; i++) {
      orbit.turn(0.1, -0.2);
    }
    Vector3d right = orbit.pose().orientation().transform(new Vector3d(1, 0, 0));
    assertThat(right.y).isCloseTo(0, within(1e-9));
    assertThat(forward().y).isGreaterThan(-1).isLessThan(-0.99);
    assertThat(position().length()).isCloseTo(10, within(1e-6));
  }

  @Test
  void comingNearerKeepsTheDirection() {
    orbit.zoom(4);
    assertThat(position().z).isBetween(4.0, 6.0);
    assertThat(forward().distance(0, 0, -1)).isLessThan(1e-9);
  }

  @Test
  void aWholePictureIsShiftedByAWholeSide() {
    orbit.pan(1, 0);
    assertThat(position().x).isCloseTo(20 * Math.tan(Math.PI / 8), within(1e-9));
  }

  @Test
  void aFramedBoxFillsThePictureAndLiesWithinIt() {
    orbit.frame(new BoundingBox(4, 4, 4, 6, 6, 6));
    Vector3d nearCorner = new Vector3d(6, 6, 6).sub(position());
    assertThat(nearCorner.x / -nearCorner.z)
        .isBetween(0.8 * Math.tan(Math.PI / 8), Math.tan(Math.PI / 8));
    assertThat(forward().distance(0, 0, -1)).isLessThan(1e-9);
    assertThat(position().x).isCloseTo(5, within(1e-9));
  }
}
