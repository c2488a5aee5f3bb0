package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.SmallScene.quad;
import static org.selectiverenderer.radiosity.SmallScene.room;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.scene.Photometry;

/** Light at texels against closed forms. */
class LawsOfLightAtTexelsTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'"; // Reflects a half.
  private static final String BLACK = "diffuseColor='0 0 0'";
  private static final double HALF = Photometry.linear(0.735);

  /** A point light without metadata. */
  private static final double CANDELA = 250 * Math.PI;

  private static String floor(double side, String material) {
    return quad(
        "%1$s 0 %2$s, %2$s 0 %2$s, %2$s 0 %1$s, %1$s 0 %1$s".formatted(-side / 2, side / 2),
        material);
  }

  @Test
  void aPointLampFallsOffWithTheSquareOfTheDistanceAndTheCosine() throws Exception {
    TexelLight lit = TexelLight.of(floor(4, BLACK) + "<PointLight location='0 1.5 0'/>", 16, 0.5);
    int[] seen = {0};
    lit.each(
        0,
        (p, lux) -> {
          double square = p[0] * p[0] + 1.5 * 1.5 + p[2] * p[2];
          double expected = CANDELA / square * 1.5 / Math.sqrt(square);
          assertThat(lux).isCloseTo(expected, within(0.01 * expected));
          seen[0]++;
        });
    assertThat(seen[0]).isEqualTo(64 * 64);
  }

  @Test
  void inAFurnaceEveryTexelHasTheSameLight() throws Exception {
    TexelLight lit =
        TexelLight.of(room(0, 0, 0, 2, GREY + " emissiveColor='0.735 0.735 0.735'"), 12, 0.5);
    double expected = Math.PI * HALF * Photometry.WHITE / (1 - HALF);
    lit.each(0, (p, lux) -> assertThat(lux).isCloseTo(expected, within(0.01 * expected)));
    assertThat(lit.pages().noise().places()).isPositive();
    assertThat(lit.pages().noise().most()).isLessThan(0.01);
  }
}
