package org.selectiverenderer.browser.nodes.event;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.scene.Node;

class InterpolatorTest {
  private static final float[] ENDS = {0, 1};
  private final TestNodes nodes = new TestNodes();

  private Node interpolator(String type, float[] key, float... keyValue) {
    return nodes.watch(nodes.node(type, "key", key, "keyValue", keyValue), "value_changed");
  }

  private float[] at(Node interpolator, float fraction) {
    nodes.send(interpolator, "set_fraction", fraction);
    return interpolator.floats("value_changed");
  }

  @ParameterizedTest
  @CsvSource({"-1,10", "0,10", "0.25,15", "0.5,20", "0.75,10", "1,0", "2,0"})
  void scalarsAreLinearBetweenKeysAndConstantOutside(float fraction, float expected) {
    Node scalar = interpolator("ScalarInterpolator", new float[] {0, 0.5f, 1}, 10, 20, 0);
    nodes.send(scalar, "set_fraction", fraction);
    assertThat(scalar.number("value_changed")).isEqualTo(expected);
  }

  @Test
  void atTwoEqualKeysTheValueJumps() {
    Node scalar = interpolator("ScalarInterpolator", new float[] {0, 0.5f, 0.5f, 1}, 0, 1, 5, 6);
    nodes.send(scalar, "set_fraction", Math.nextDown(0.5f));
    assertThat(scalar.number("value_changed")).isBetween(0.99f, 1f);
    nodes.send(scalar, "set_fraction", 0.5f);
    assertThat(scalar.number("value_changed")).isEqualTo(5);
  }

  @Test
  void positionsAndCoordinatesGoTupleByTuple() {
    assertThat(at(interpolator("PositionInterpolator", ENDS, 0, 0, 0, 2, 4, 8), 0.5f))
        .containsExactly(1, 2, 4);
    assertThat(at(interpolator("PositionInterpolator2D", ENDS, 0, 0, 2, 4), 0.25f))
        .containsExactly(0.5f, 1);
    float[] two = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
    assertThat(at(interpolator("CoordinateInterpolator", ENDS, two), 0.5f))
        .containsExactly(1, 1, 1, 2, 2, 2);
    assertThat(at(interpolator("CoordinateInterpolator2D", ENDS, 0, 0, 1, 1, 2, 2, 3, 3), 0.5f))
        .containsExactly(1, 1, 2, 2);
  }

  @Test
  void rotationsTakeTheShortWay() {
    // From 170 to -170 degrees about Y is 20 degrees through the back, not 340 through the front.
    float near = (float) Math.toRadians(170);
    Node turn = interpolator("OrientationInterpolator", ENDS, 0, 1, 0, near, 0, 1, 0, -near);
    float[] half = at(turn, 0.5f);
    assertThat(Math.abs(half[1])).isEqualTo(1);
    assertThat(half[3]).isCloseTo((float) Math.PI, Offset.offset(1e-6f));
  }

  @Test
  void rotationsTurnEvenly() {
    Node turn = interpolator("OrientationInterpolator", ENDS, 1, 0, 0, 0, 1, 0, 0, 2);
    assertThat(at(turn, 0.25f)).usingComparatorWithPrecision(1e-6f).containsExactly(1, 0, 0, 0.5f);
    assertThat(at(turn, 1)).containsExactly(1, 0, 0, 2);
  }

  @Test
  void coloursGoThroughTheHues() {
    // Red to blue the short way is through magenta, red to green through yellow.
    assertThat(at(interpolator("ColorInterpolator", ENDS, 1, 0, 0, 0, 0, 1), 0.5f))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(1, 0, 1);
    assertThat(at(interpolator("ColorInterpolator", ENDS, 1, 0, 0, 0, 1, 0), 0.5f))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(1, 1, 0);
    assertThat(at(interpolator("ColorInterpolator", ENDS, 1, 1, 1, 0, 0, 1), 0.5f))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(0.5f, 0.5f, 1);
  }

  @Test
  void hueSaturationAndValueComeBackAsTheSameColour() {
    float[] hsv = new float[3];
    float[] rgb = new float[3];
    for (float r = 0; r <= 1; r += 0.25f) {
      for (float g = 0; g <= 1; g += 0.25f) {
        for (float b = 0; b <= 1; b += 0.25f) {
          HsvColor.of(new float[] {r, g, b}, 0, hsv);
          HsvColor.rgb(hsv[0], hsv[1], hsv[2], rgb, 0);
          assertThat(rgb).usingComparatorWithPrecision(1e-5f).containsExactly(r, g, b);
        }
      }
    }
  }

  @Test
  void normalsStayOfUnitLength() {
    float half = (float) Math.sqrt(0.5);
    assertThat(at(interpolator("NormalInterpolator", ENDS, 1, 0, 0, 0, 1, 0), 0.5f))
        .usingComparatorWithPrecision(1e-6f)
        .containsExactly(half, half, 0);
    assertThat(at(interpolator("NormalInterpolator", ENDS, 1, 0, 0, -1, 0, 0), 0.5f))
        .containsExactly(1, 0, 0);
  }

  @Test
  void missingValuesAreSilentOrShortenTheKeys() {
    nodes.send(interpolator("PositionInterpolator", ENDS), "set_fraction", 0.5f);
    nodes.send(interpolator("PositionInterpolator", new float[0], 1, 2, 3), "set_fraction", 0.5f);
    nodes.send(interpolator("CoordinateInterpolator", ENDS, 1, 2, 3), "set_fraction", 0.5f);
    nodes.send(interpolator("ScalarInterpolator", ENDS, 1, 2), "set_fraction", Float.NaN);
    assertThat(nodes.sent()).isEmpty();
    nodes.send(interpolator("ScalarInterpolator", ENDS, 7), "set_fraction", 0.9f);
    assertThat(nodes.sent()).containsExactly("value_changed=7.0");
  }

  @ParameterizedTest
  @CsvSource({"0,0", "0.25,0.125", "0.5,0.5", "0.75,0.875", "1,1"})
  void easingIsSlowAtBothEnds(float fraction, float expected) {
    Node ease =
        nodes.node("EaseInEaseOut", "key", ENDS, "easeInEaseOut", new float[] {0, 0.5f, 0.5f, 0});
    nodes.send(ease, "set_fraction", fraction);
    assertThat(ease.number("modifiedFraction_changed")).isEqualTo(expected);
  }
}
