package org.selectiverenderer.base.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class PngFileTest {
  @Test
  void anotherReaderFindsThePixels() throws IOException {
    byte[] rgb = new byte[3 * 70 * 200];
    new Random(1).nextBytes(rgb);
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(PngFile.of(70, 200, rgb)));
    assertThat(image.getWidth()).isEqualTo(70);
    assertThat(image.getHeight()).isEqualTo(200);
    for (int pixel = 0; pixel < 70 * 200; pixel++) {
      int expected =
          (rgb[3 * pixel] & 0xff) << 16
              | (rgb[3 * pixel + 1] & 0xff) << 8
              | rgb[3 * pixel + 2] & 0xff;
      assertThat(image.getRGB(pixel % 70, pixel / 70) & 0xffffff).isEqualTo(expected);
    }
  }
}
