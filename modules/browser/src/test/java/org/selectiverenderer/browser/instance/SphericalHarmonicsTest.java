package org.selectiverenderer.browser.instance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SphericalHarmonicsTest {
  private static final int TOP = 4;

  @Test
  void lightThatIsTheSameAllAroundIsThrownBackWhole() {
    double[] found = SphericalHarmonics.of(cube(255, 255, 255, 255, 255, 255), true);
    assertThat(thrownBack(found, 0, 1, 0)).isEqualTo(1, within(1e-3));
    assertThat(thrownBack(found, 0.6, 0, -0.8)).isEqualTo(1, within(1e-3));
  }

  @Test
  void aFaceOfACubeLightsWhatLooksAtItByItsFormFactor() {
    int[] grey = new int[CubeTexture.FACES];
    grey[TOP] = 255;
    double[] found = SphericalHarmonics.of(cube(grey), true);
    // Of a square as large as a cube's side, seen from its middle (J. R. Howell, C-11): 0.5541.
    assertThat(thrownBack(found, 0, 1, 0)).isEqualTo(0.5541, within(0.02));
    assertThat(thrownBack(found, 0, -1, 0)).isEqualTo(0, within(0.04));
    assertThat(thrownBack(found, 1, 0, 0)).isEqualTo(thrownBack(found, 0, 0, -1), within(1e-5));
  }

  @Test
  void eachFaceLightsItsOwnSide() {
    double[][] middles = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (int face = 0; face < CubeTexture.FACES; face++) {
      int[] grey = new int[CubeTexture.FACES];
      grey[face] = 255;
      double[] m = middles[face];
      assertThat(thrownBack(SphericalHarmonics.of(cube(grey), true), m[0], m[1], m[2]))
          .isGreaterThan(0.5);
    }
  }

  @Test
  void coefficientsThatAreMissingOrNoNumbersCountAsNone() {
    double[] found = SphericalHarmonics.ofFalling(new float[] {(float) Math.PI, Float.NaN});
    assertThat(found).hasSize(27).endsWith(new double[26]);
    assertThat(found[0]).isEqualTo(1, within(1e-6));
  }

  private static CubeTexture cube(int... grey) {
    List<CubeTexture.Face> faces = new ArrayList<>();
    for (int value : grey) {
      byte of = (byte) value;
      Texture.Image image = new Texture.Image(1, 1, 1, new byte[] {of, of, of, (byte) 255});
      faces.add(new CubeTexture.Face(image, 0));
    }
    return new CubeTexture(faces, null);
  }

  /** As {@code environment.glsl} has it, of red. */
  private static double thrownBack(double[] c, double x, double y, double z) {
    Vector3d n = new Vector3d(x, y, z).normalize();
    return 0.282095 * c[0]
        + 0.488603 * (n.y * c[3] + n.z * c[6] + n.x * c[9])
        + 1.092548 * (n.x * n.y * c[12] + n.y * n.z * c[15] + n.x * n.z * c[21])
        + 0.315392 * (3 * n.z * n.z - 1) * c[18]
        + 0.546274 * (n.x * n.x - n.y * n.y) * c[24];
  }
}
