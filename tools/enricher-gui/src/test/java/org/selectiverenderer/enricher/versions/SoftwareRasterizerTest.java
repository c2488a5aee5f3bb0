package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Two squares, one behind the other, are looked at from the front of the nearer one. */
class SoftwareRasterizerTest {
  private static final int SIDE = 40;
  private static final int CENTRE = SIDE / 2 * SIDE + SIDE / 2;
  private final int[] pixels = new int[SIDE * SIDE];
  private final SoftwareRasterizer painter = new SoftwareRasterizer(pixels, SIDE, SIDE);
  private final TurntableCamera front = new TurntableCamera();

  SoftwareRasterizerTest() {
    front.turn(-0.6, -0.35); // from where one begins to the z axis
  }

  private static float[] square(float half, float z) {
    return new float[] {
      -half, -half, z, half, -half, z, half, half, z, //
      -half, -half, z, half, half, z, -half, half, z
    };
  }

  private static ColoredMesh shape() {
    float[] corners = new float[36];
    System.arraycopy(square(1, 1), 0, corners, 0, 18);
    System.arraycopy(square(1, -1), 0, corners, 18, 18);
    return new ColoredMesh(corners, new int[] {0xFF0000, 0xFF0000, 0x00FF00, 0x00FF00});
  }

  @Test
  void theNearerFaceHidesTheOneBehind() {
    painter.solid(shape(), shape().frame(), front);
    assertThat(pixels[CENTRE] & 0xFF00).isZero();
    assertThat(pixels[CENTRE] & 0xFF0000).isNotZero();
    front.turn(Math.PI, 0);
    Arrays.fill(pixels, 0);
    painter.solid(shape(), shape().frame(), front);
    assertThat(pixels[CENTRE] & 0xFF0000).isZero();
    assertThat(pixels[CENTRE] & 0xFF00).isNotZero();
  }

  @Test
  void wiresAreTheEdgesOnly() {
    painter.wires(shape(), shape().frame(), front, 0x123456);
    assertThat(Arrays.stream(pixels).filter(p -> p == 0x123456).count()).isBetween(50L, 400L);
    assertThat(pixels[CENTRE + 5]).isZero(); // between the diagonal and the sides
  }

  @Test
  void everythingFitsIntoThePicture() {
    for (int i = 0; i < 12; i++) {
      front.turn(Math.PI / 6, 0.1);
      Arrays.fill(pixels, 0);
      painter.solid(shape(), shape().frame(), front);
      for (int k = 0; k < SIDE; k++) {
        assertThat(pixels[k]).isZero();
        assertThat(pixels[SIDE * k]).isZero();
      }
    }
  }
}
