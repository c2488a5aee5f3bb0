package org.selectiverenderer.bench.versions;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The similarity is that of the published formula, and of scikit-image 0.26 for a pattern. */
class StructuralSimilarityTest {
  private static final int WIDTH = 40;
  private static final int HEIGHT = 30;

  /** A wave over a slope; {@code shift} moves the wave, {@code noise} adds a chequered pattern. */
  private static double[] pattern(int shift, int noise) {
    double[] picture = new double[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        int wave = (x + shift) * (x + shift) % 97 + 2 * y;
        picture[y * WIDTH + x] = wave + noise * ((x + y) % 2);
      }
    }
    return picture;
  }

  private static double[] plain(double grey) {
    double[] picture = new double[WIDTH * HEIGHT];
    Arrays.fill(picture, grey);
    return picture;
  }

  @Test
  void equalPicturesAreWhollySimilar() {
    assertThat(StructuralSimilarity.of(pattern(0, 0), pattern(0, 0), WIDTH))
        .isCloseTo(1, within(1e-12));
  }

  @Test
  void plainPicturesDifferByTheirMeansAlone() {
    double c1 = 2.55 * 2.55;
    assertThat(StructuralSimilarity.of(plain(100), plain(50), WIDTH))
        .isCloseTo((2 * 100 * 50 + c1) / (100 * 100 + 50 * 50 + c1), within(1e-9));
  }

  @Test
  void patternsAreAsSimilarAsThePublishedProgramsSay() {
    assertThat(StructuralSimilarity.of(pattern(0, 0), pattern(0, 30), WIDTH))
        .isCloseTo(0.84982996255562, within(1e-6));
    assertThat(StructuralSimilarity.of(pattern(0, 0), pattern(3, 0), WIDTH))
        .isCloseTo(-0.05384536560802047, within(1e-6));
    assertThat(StructuralSimilarity.of(pattern(3, 0), pattern(0, 0), WIDTH))
        .isCloseTo(-0.05384536560802047, within(1e-6));
  }

  @Test
  void greenIsBrighterThanRedAndBlue() {
    byte[] rgba = {(byte) 255, 0, 0, 0, 0, (byte) 255, 0, 0, 0, 0, (byte) 255, 0};
    assertThat(StructuralSimilarity.grey(rgba))
        .containsExactly(new double[] {76.245, 149.685, 29.07}, within(1e-9));
  }

  @Test
  void picturesThatCannotBeComparedAreRefused() {
    assertThatThrownBy(() -> StructuralSimilarity.of(plain(1), new double[9], WIDTH))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> StructuralSimilarity.of(new double[100], new double[100], 10))
        .hasMessageContaining("11 by 11");
  }
}
