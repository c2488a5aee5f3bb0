package org.selectiverenderer.formats.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PictureSizeTest {
  private static byte[] picture(String format) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    BufferedImage image = new BufferedImage(300, 7, BufferedImage.TYPE_INT_RGB);
    assertThat(ImageIO.write(image, format, bytes)).isTrue();
    return bytes.toByteArray();
  }

  private static Optional<PictureSize> size(byte[] file) throws IOException {
    return PictureSize.read(new ByteArrayInputStream(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "jpg", "gif", "bmp"})
  void theBeginningOfAFileStatesItsSize(String format) throws IOException {
    assertThat(size(picture(format))).contains(new PictureSize(300, 7));
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "jpg", "gif", "bmp"})
  void aFileThatEndsEarlyHasNoSize(String format) throws IOException {
    byte[] file = picture(format);
    for (int length = 0; length < 10; length++) {
      assertThat(size(Arrays.copyOf(file, length))).isEmpty();
    }
  }

  @Test
  void compressedTexturesStateItToo() throws IOException {
    byte[] dds = new byte[32];
    System.arraycopy("DDS ".getBytes(), 0, dds, 0, 4);
    dds[12] = 16; // height
    dds[16] = 0;
    dds[17] = 1; // width 256
    assertThat(size(dds)).contains(new PictureSize(256, 16));
    byte[] ktx = new byte[32];
    byte[] magic = {(byte) 0xab, 'K', 'T', 'X', ' ', '2', '0', (byte) 0xbb, '\r', '\n', 26, '\n'};
    System.arraycopy(magic, 0, ktx, 0, magic.length);
    ktx[20] = 64;
    ktx[24] = 32;
    assertThat(size(ktx)).contains(new PictureSize(64, 32));
  }

  @Test
  void otherFilesAndAbsurdSizesHaveNone() throws IOException {
    assertThat(size("<X3D/>......".getBytes())).isEmpty();
    byte[] png = picture("png");
    png[16] = 127; // two thousand million pixels wide
    assertThat(size(png)).isEmpty();
  }

  @Test
  void mipMapsTakeAThirdMore() {
    assertThat(new PictureSize(1, 1).textureBytes()).isEqualTo(4);
    assertThat(new PictureSize(4, 2).textureBytes()).isEqualTo(4 * (8 + 2 + 1));
    assertThat(new PictureSize(1024, 1024).textureBytes()).isEqualTo(5_592_404);
  }
}
