package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class LightStorageSettingsTest {
  private static LightStorageSettings withNoise(double percent) {
    return new LightStorageSettings(
        LightStorageSettings.Kind.TEXTURES, OptionalDouble.empty(), 24, true, percent);
  }

  @Test
  void noiseThatCannotBeWishedForIsRefused() {
    assertThat(withNoise(0.1).noise()).isEqualTo(0.1);
    for (double percent : new double[] {0, -3, 101, Double.NaN}) {
      assertThatThrownBy(() -> withNoise(percent))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("the noise must be from 0.1 to 100 percent");
    }
  }
}
