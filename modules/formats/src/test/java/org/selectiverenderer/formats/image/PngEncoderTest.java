package org.selectiverenderer.formats.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class PngEncoderTest {
  @Test
  void anotherReaderFindsThePixels() throws IOException {
    byte[] rgb = new byte[3 * 70 * 200];
    new Random(1).nextBytes(rgb);
    same(rgb, PngEncoder.of(70, 200, rgb));
  }

  @Test
  void everyFilterIsUsedAndUndone() throws IOException {
    byte[] rgb = new byte[3 * 70 * 200];
    Random random = new Random(2);
    for (int y = 0; y < 200; y++) {
      for (int i = 0; i < 210; i++) {
        int value =
            switch (y / 40) {
              case 0 -> random.nextInt(2) * 255; // as it is
              case 1 -> 7 * y + 3 * (i / 3); // as its left neighbour, nearly
              case 2 -> i * i % 251; // as the one above
              case 3 -> 2 * y + 2 * (i / 3) + random.nextInt(9); // between both
              default -> (i / 3 * y) / 4; // along a slope
            };
        rgb[y * 210 + i] = (byte) value;
      }
    }
    byte[] filtered = PngRowFilter.filtered(210, 200, 3, rgb);
    Set<Byte> used = new HashSet<>();
    for (int y = 0; y < 200; y++) {
      used.add(filtered[211 * y]);
    }
    assertThat(used).hasSize(5);
    byte[] small = PngEncoder.small(70, 200, rgb);
    same(rgb, small);
    assertThat(small.length).isLessThan(PngEncoder.of(70, 200, rgb).length);
  }

  private static void same(byte[] rgb, byte[] file) throws IOException {
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
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
