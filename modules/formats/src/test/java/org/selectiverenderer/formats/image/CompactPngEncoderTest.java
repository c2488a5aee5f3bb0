package org.selectiverenderer.formats.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;

class CompactPngEncoderTest {
  private static final int WIDTH = 37;
  private static final int HEIGHT = 23;

  /** Smooth, rough and flat rows, so that every filter has its turn. */
  @ParameterizedTest
  @EnumSource(Samples.class)
  void anotherReaderFindsTheSamples(Samples samples) throws IOException {
    byte[] palette = new byte[3 * 256];
    new Random(2).nextBytes(palette);
    byte[] pixels = new byte[WIDTH * HEIGHT * samples.count()];
    new Random(1).nextBytes(pixels);
    for (int i = 0; i < pixels.length; i++) {
      int row = i / (WIDTH * samples.count());
      pixels[i] = row < 6 ? pixels[i] : (byte) (row < 14 ? i / 3 + row * row : row * 9);
    }

    byte[] file =
        CompactPngEncoder.of(
            WIDTH, HEIGHT, samples, samples == Samples.PALETTE ? palette : new byte[0], pixels);

    BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
    assertThat(image.getWidth()).isEqualTo(WIDTH);
    assertThat(image.getHeight()).isEqualTo(HEIGHT);
    int[] found = image.getRaster().getPixels(0, 0, WIDTH, HEIGHT, (int[]) null);
    assertThat(found).hasSameSizeAs(pixels);
    for (int i = 0; i < pixels.length; i++) {
      assertThat(found[i]).isEqualTo(pixels[i] & 0xff);
    }
    if (samples == Samples.PALETTE) {
      int first = pixels[0] & 0xff;
      int expected =
          (palette[3 * first] & 0xff) << 16
              | (palette[3 * first + 1] & 0xff) << 8
              | palette[3 * first + 2] & 0xff;
      assertThat(image.getRGB(0, 0) & 0xffffff).isEqualTo(expected);
    }
  }

  @Test
  void aSlopeTakesLessThanWithoutFilters() {
    byte[] rgb = new byte[3 * 256 * 256];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (byte) (i / 3 % 256 + i / 768 * 3 + i % 3 * 40);
    }

    assertThat(CompactPngEncoder.of(256, 256, Samples.RGB, new byte[0], rgb).length)
        .isLessThan(PngEncoder.of(256, 256, rgb).length);
  }
}
