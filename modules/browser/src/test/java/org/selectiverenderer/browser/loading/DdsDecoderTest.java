package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

class DdsDecoderTest {
  private static final int RGB = 0x40;
  private static final int RGBA = 0x41;
  private static final int CUBE = 0xfe00;

  @TempDir private Path folder;

  /** The head of a file with 32 bits per pixel, or compressed, and room for so many bytes. */
  private static ByteBuffer file(int width, int height, int flags, String name, int bytes) {
    ByteBuffer file = ByteBuffer.allocate(128 + bytes).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0, 0x20534444).putInt(4, 124).putInt(12, height).putInt(16, width);
    file.putInt(76, 32).putInt(80, flags);
    for (int i = 0; i < name.length(); i++) {
      file.put(84 + i, (byte) name.charAt(i));
    }
    file.putInt(88, 32);
    file.putInt(92, 0xff0000).putInt(96, 0xff00).putInt(100, 0xff).putInt(104, 0xff000000);
    return file.position(128);
  }

  private Texture.Image decode(ByteBuffer file) throws IOException {
    Path path = folder.resolve("a.dds");
    Files.write(path, file.array());
    return ImageDecoder.read(
        new UrlContent.OfFile(path, path.toString()), new AtomicLong(Long.MAX_VALUE));
  }

  @Test
  void theFirstRowOfTheFileIsTheHighest() throws IOException {
    Texture.Image image = decode(file(1, 2, RGBA, "", 8).putInt(0x80010203).putInt(0x40040506));
    assertThat(image.rgba()).containsExactly(4, 5, 6, 0x40, 1, 2, 3, -128);
    assertThat(image.components()).isEqualTo(4);
    assertThat(image.layers()).isEqualTo(1);
  }

  @Test
  void withoutAlphaEveryPixelIsOpaque() throws IOException {
    Texture.Image image = decode(file(1, 1, RGB, "", 4).putInt(0x00010203));
    assertThat(image.rgba()).containsExactly(1, 2, 3, -1);
    assertThat(image.components()).isEqualTo(3);
  }

  @Test
  void pixelsOfABlockAreOneOfFourColours() throws IOException {
    // Red and blue; the upper row is red, blue and the two in between.
    ByteBuffer block = file(4, 1, 0x4, "DXT1", 8).putShort((short) 0xf800).putShort((short) 0x1f);
    Texture.Image image = decode(block.putInt(0b11_10_01_00));
    assertThat(image.rgba())
        .containsExactly(-1, 0, 0, -1, 0, 0, -1, -1, 170, 0, 85, -1, 85, 0, (byte) 170, -1);
  }

  @Test
  void aBlockMayHaveOpacityOfItsOwn() throws IOException {
    ByteBuffer explicit = file(1, 1, 0x4, "DXT3", 16).putLong(0x8).putShort((short) 0xf800);
    assertThat(decode(explicit).rgba()).containsExactly(-1, 0, 0, 0x88);
    // Between 70 and 0 in sevenths; the pixel takes the first step down.
    ByteBuffer steps = file(1, 1, 0x4, "DXT5", 16).putLong(0x20046L).putShort((short) 0xf800);
    assertThat(decode(steps).rgba()).containsExactly(-1, 0, 0, 60);
  }

  @Test
  void aCubeHasSixFacesAsSeenFromItsMiddle() throws IOException {
    ByteBuffer file = file(2, 2, RGB, "", 6 * 16);
    file.putInt(112, CUBE);
    for (int face = 0; face < 6; face++) {
      for (int pixel = 0; pixel < 4; pixel++) {
        file.putInt(16 * face + pixel);
      }
    }
    Texture.Image image = decode(file);
    assertThat(image.layers()).isEqualTo(6);
    // The front is the file's sixth, mirrored; its lower left pixel the file's lower right.
    assertThat(image.rgba()[2]).isEqualTo((byte) 0x53);
    // The top is the file's third, upside down; its lower left pixel the file's upper left.
    assertThat(image.rgba()[4 * 16 + 2]).isEqualTo((byte) 0x20);
  }

  @Test
  void aVolumeHasItsSlices() throws IOException {
    ByteBuffer file = file(1, 1, RGB, "", 8);
    file.putInt(112, 0x200000).putInt(24, 2);
    Texture.Image image = decode(file.putInt(1).putInt(2));
    assertThat(image.layers()).isEqualTo(2);
    assertThat(image.rgba()).containsExactly(0, 0, 1, -1, 0, 0, 2, -1);
  }

  @Test
  void whatIsDamagedOrUnknownIsRefused() {
    assertThatThrownBy(() -> decode(file(100, 100, RGB, "", 4)))
        .hasMessage("is a damaged DDS image: it ends too early");
    assertThatThrownBy(() -> decode(file(0, 1, RGB, "", 4)))
        .hasMessage("is a damaged DDS image: its width or height is 0");
    assertThatThrownBy(() -> decode(file(Integer.MAX_VALUE, 1 << 30, RGB, "", 4)))
        .hasMessageContaining("more than the limit");
    assertThatThrownBy(() -> decode(file(1, 1, 0x4, "DX10", 16)))
        .hasMessage(
            "is a DDS image in an unsupported format" + " (use uncompressed, DXT1, DXT3 or DXT5)");
  }
}
