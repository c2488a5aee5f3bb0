package org.selectiverenderer.browser.nodes.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The formulas of X3D 4.0, 16.2.3 and 16.4.18. */
class SpatialAudioGainTest {
  private static final SpatialAudioGain.Ellipsoids DEFAULT = sound(1, 1, 10, 10);

  private static SpatialAudioGain.Ellipsoids sound(double minFront, double minBack, double... max) {
    return new SpatialAudioGain.Ellipsoids(
        new Vector3d(), new Vector3d(0, 0, 1), minFront, minBack, max[0], max[1]);
  }

  private static SpatialAudioGain at(
      SpatialAudioGain.Ellipsoids sound, double x, double y, double z) {
    return SpatialAudioGain.of(
        sound, new Matrix4d(), new Vector3d(x, y, z), new Quaterniond(), true);
  }

  private static void assertHeard(SpatialAudioGain heard, double gain, double left, double right) {
    assertThat(heard.gain()).isEqualTo(gain, within(1e-9));
    assertThat(heard.left()).isEqualTo(left, within(1e-9));
    assertThat(heard.right()).isEqualTo(right, within(1e-9));
  }

  @Test
  void withinTheInnerEllipsoidItIsLoudAndWithoutDirection() {
    assertHeard(at(DEFAULT, 0, 0, 0), 1, 1, 1);
    assertHeard(at(DEFAULT, 1, 0, 0), 1, 1, 1);
  }

  @Test
  void betweenTheEllipsoidsDecibelsFallEvenlyTo20() {
    assertThat(at(DEFAULT, 0, 0, 5.5).gain()).isEqualTo(Math.pow(10, -0.5), within(1e-9));
    assertThat(at(DEFAULT, 0, 0, 9.9999999).gain()).isEqualTo(0.1, within(1e-6));
    assertThat(at(DEFAULT, 0, 0, 10).gain()).isZero();
    assertThat(at(DEFAULT, 0, -11, 0).gain()).isZero();
  }

  /** In front of the viewer 0.5, which leaves 1 - 0.5² for each ear. */
  @Test
  void theAngleAboutTheViewerPans() {
    assertHeard(at(DEFAULT, 0, 0, 5.5), Math.pow(10, -0.5), 0.75, 0.75);
    assertHeard(at(DEFAULT, 0, 0, -5.5), Math.pow(10, -0.5), 0.75, 0.75);
    assertHeard(at(DEFAULT, -5.5, 0, 0), Math.pow(10, -0.5), 0, 1);
    assertHeard(at(DEFAULT, 5.5, 0, 0), Math.pow(10, -0.5), 1, 0);
    SpatialAudioGain between = at(DEFAULT, -3, 0, 3);
    assertThat(between.left()).isEqualTo(1 - 0.75 * 0.75, within(1e-9));
    assertThat(between.right()).isEqualTo(1 - 0.25 * 0.25, within(1e-9));
    SpatialAudioGain above = at(DEFAULT, 0, -5.5, 0);
    assertThat(above.left()).isEqualTo(0.75, within(1e-9));
  }

  @Test
  void theHeadTurnsTheSound() {
    Quaterniond toTheRight = new Quaterniond().rotateY(-Math.PI / 2);
    SpatialAudioGain heard =
        SpatialAudioGain.of(DEFAULT, new Matrix4d(), new Vector3d(0, 0, 5), toTheRight, true);
    assertThat(heard.left()).isEqualTo(1, within(1e-9));
    assertThat(heard.right()).isEqualTo(0, within(1e-9));
  }

  @Test
  void withoutSpatializeDistanceAloneCounts() {
    SpatialAudioGain heard =
        SpatialAudioGain.of(
            DEFAULT, new Matrix4d(), new Vector3d(5.5, 0, 0), new Quaterniond(), false);
    assertHeard(heard, Math.pow(10, -0.5), 1, 1);
  }

  /** An ellipse with the sound in a focus: at its side it reaches 2fb / (f + b). */
  @Test
  void frontAndBackReachDifferently() {
    SpatialAudioGain.Ellipsoids sound = sound(6, 2, 60, 20);
    assertThat(at(sound, 0, 0, 6).gain()).isEqualTo(1);
    assertThat(at(sound, 0, 0, -2).gain()).isEqualTo(1);
    assertThat(at(sound, 2.999, 0, 0).gain()).isEqualTo(1);
    assertThat(at(sound, 3.01, 0, 0).gain()).isLessThan(1);
    assertThat(at(sound, 0, 0, 59.9).gain()).isEqualTo(0.1, within(1e-3));
    assertThat(at(sound, 0, 0, -20).gain()).isZero();
    assertThat(at(sound, 29.9, 0, 0).gain()).isEqualTo(0.1, within(1e-3));
    assertThat(at(sound, 30.1, 0, 0).gain()).isZero();
  }

  @Test
  void theSoundStandsWhereItsTransformationPutsIt() {
    Matrix4d place = new Matrix4d().translate(100, 0, 0).scale(2);
    SpatialAudioGain heard =
        SpatialAudioGain.of(DEFAULT, place, new Vector3d(111, 0, 0), new Quaterniond(), true);
    assertHeard(heard, Math.pow(10, -0.5), 1, 0);
    Matrix4d flat = new Matrix4d().scale(1, 0, 1);
    assertThat(SpatialAudioGain.of(DEFAULT, flat, new Vector3d(), new Quaterniond(), true))
        .isSameAs(SpatialAudioGain.NOTHING);
  }

  @Test
  void noExtentIsNoSound() {
    assertThat(at(sound(0, 0, 0, 0), 0.1, 0, 0).gain()).isZero();
    assertThat(at(sound(5, 5, 1, 1), 3, 0, 0).gain()).isEqualTo(1);
    assertThat(at(sound(5, 5, 1, 1), 6, 0, 0).gain()).isZero();
  }
}
