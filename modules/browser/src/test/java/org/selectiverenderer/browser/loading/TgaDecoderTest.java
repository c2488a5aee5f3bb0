package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

class TgaDecoderTest {
  @TempDir private Path folder;

  /** A picture of 2 x 1 pixels. */
  private Texture.Image decode(int kind, int bits, int descriptor, int... data) throws IOException {
    byte[] file = new byte[18 + data.length];
    file[2] = (byte) kind;
    file[12] = 2;
    file[14] = 1;
    file[16] = (byte) bits;
    file[17] = (byte) descriptor;
    for (int i = 0; i < data.length; i++) {
      file[18 + i] = (byte) data[i];
    }
    if (kind % 8 == 1) {
      file[1] = 1;
      file[5] = 2;
      file[7] = 24;
    }
    Path path = folder.resolve("A.TGA");
    Files.write(path, file);
    return ImageDecoder.read(
        new UrlContent.OfFile(path, path.toString()), new AtomicLong(Long.MAX_VALUE));
  }

  @Test
  void coloursAreBlueGreenRed() throws IOException {
    assertThat(decode(2, 24, 0, 3, 2, 1, 6, 5, 4).rgba()).containsExactly(1, 2, 3, -1, 4, 5, 6, -1);
    Texture.Image clear = decode(2, 32, 0, 3, 2, 1, 7, 6, 5, 4, 8);
    assertThat(clear.rgba()).containsExactly(1, 2, 3, 7, 4, 5, 6, 8);
    assertThat(clear.components()).isEqualTo(4);
  }

  @Test
  void greyHasOneComponentAndMayBeginRight() throws IOException {
    Texture.Image image = decode(3, 8, 0x10, 1, 2);
    assertThat(image.rgba()).containsExactly(2, 2, 2, -1, 1, 1, 1, -1);
    assertThat(image.components()).isEqualTo(1);
  }

  @Test
  void runsAreRepeatedAndPaletteEntriesLookedUp() throws IOException {
    assertThat(decode(10, 24, 0, 0x81, 3, 2, 1).rgba()).containsExactly(1, 2, 3, -1, 1, 2, 3, -1);
    assertThat(decode(1, 8, 0, 3, 2, 1, 6, 5, 4, 1, 0).rgba())
        .containsExactly(4, 5, 6, -1, 1, 2, 3, -1);
  }

  @Test
  void whatIsDamagedOrUnknownIsRefused() {
    assertThatThrownBy(() -> decode(2, 24, 0, 1)).hasMessage("is a damaged image");
    assertThatThrownBy(() -> decode(2, 16, 0, 1, 2, 3, 4))
        .hasMessageStartingWith("is a TGA image in an unsupported format");
  }
}
