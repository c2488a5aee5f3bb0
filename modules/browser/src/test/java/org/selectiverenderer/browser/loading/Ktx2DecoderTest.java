package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class Ktx2DecoderTest {
  private static final int RGBA = 37;
  private static final int RGB = 23;

  private static ByteBuffer file(int format, int width, int height, int... pixels) {
    byte[] bytes = new byte[pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      bytes[i] = (byte) pixels[i];
    }
    return file(format, width, height, bytes);
  }

  /** Returns a file of one level whose pixels are the bytes. */
  private static ByteBuffer file(int format, int width, int height, byte[] pixels) {
    ByteBuffer file = ByteBuffer.allocate(104 + pixels.length).order(ByteOrder.LITTLE_ENDIAN);
    file.put(new byte[] {(byte) 0xab, 'K', 'T', 'X', ' ', '2', '0', (byte) 0xbb, 13, 10, 26, 10});
    file.putInt(12, format).putInt(16, 1).putInt(20, width).putInt(24, height);
    file.putInt(36, 1).putInt(40, 1);
    file.putLong(80, 104).putLong(88, pixels.length).putLong(96, pixels.length);
    return file.put(104, pixels);
  }

  private static Texture.Image decode(ByteBuffer file) throws IOException {
    UrlContent content =
        new UrlContent.OfBytes("a", "a.ktx2", BaseUrl.folder(Path.of("")), file.array());
    return ImageDecoder.read(content, new AtomicLong(Long.MAX_VALUE));
  }

  @Test
  void theFirstRowOfTheFileIsTheHighestUnlessItSaysOtherwise() throws IOException {
    ByteBuffer file = file(RGBA, 1, 2, 1, 2, 3, 4, 5, 6, 7, 8);
    assertThat(decode(file).rgba()).containsExactly(5, 6, 7, 8, 1, 2, 3, 4);
    assertThat(decode(file).components()).isEqualTo(4);

    byte[] entry = "\22\0\0\0KTXorientation\0ru\0".getBytes(StandardCharsets.ISO_8859_1);
    ByteBuffer upward = ByteBuffer.allocate(file.capacity() + entry.length);
    upward.order(ByteOrder.LITTLE_ENDIAN).put(file.array()).put(entry);
    upward.putInt(56, file.capacity()).putInt(60, entry.length);
    assertThat(decode(upward).rgba()).containsExactly(1, 2, 3, 4, 5, 6, 7, 8);
  }

  @Test
  void channelsAreOfTheFormatsOrderAndSize() throws IOException {
    assertThat(decode(file(RGB, 1, 1, 1, 2, 3)).rgba()).containsExactly(1, 2, 3, -1);
    assertThat(decode(file(50, 1, 1, 1, 2, 3, 4)).rgba()).containsExactly(3, 2, 1, 4);
    assertThat(decode(file(36, 1, 1, 1, 2, 3)).rgba()).containsExactly(3, 2, 1, -1);
    assertThat(decode(file(16, 1, 1, 1, 2)).rgba()).containsExactly(1, 2, 0, -1);
    assertThat(decode(file(9, 1, 1, 7)).rgba()).containsExactly(7, 7, 7, -1);
    assertThat(decode(file(9, 1, 1, 7)).components()).isEqualTo(1);
    assertThat(decode(file(91, 1, 1, 0, 1, 0, 2, 0, 3, 0, 4)).rgba()).containsExactly(1, 2, 3, 4);
    // 0.5, 0 and 2^-24 as halves; 1 of 16 bits is 0x3c00.
    assertThat(decode(file(97, 1, 1, 0, 0x38, 0, 0, 1, 0, 0, 0x3c)).rgba())
        .containsExactly(-68, 0, 0, -1);
    ByteBuffer light = ByteBuffer.allocate(12).order(ByteOrder.LITTLE_ENDIAN);
    light.putFloat(0.5f).putFloat(Float.NaN).putFloat(-3);
    assertThat(decode(file(106, 1, 1, light.array())).rgba()).containsExactly(-68, 0, 0, -1);
  }

  @Test
  void blocksAreThoseOfADdsImage() throws IOException {
    ByteBuffer block = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);
    block.putShort((short) 0xf800).putShort((short) 0x1f).putInt(0b11_10_01_00);
    assertThat(decode(file(131, 4, 1, block.array())).rgba())
        .containsExactly(-1, 0, 0, -1, 0, 0, -1, -1, -86, 0, 85, -1, 85, 0, -86, -1);
    ByteBuffer deep = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
    deep.putLong(0x20046L).putShort((short) 0xf800);
    assertThat(decode(file(137, 1, 1, deep.array())).rgba()).containsExactly(-1, 0, 0, 60);
  }

  @Test
  void aCubeAndAVolumeHaveTheirLayers() throws IOException {
    byte[] faces = new byte[6 * 12];
    for (int i = 0; i < faces.length; i++) {
      faces[i] = (byte) (i / 3);
    }
    Texture.Image cube = decode(file(RGB, 2, 2, faces).putInt(36, 6));
    assertThat(cube.layers()).isEqualTo(6);
    // The front is the sixth face, mirrored; its lower left pixel the file's lower right.
    assertThat(cube.rgba()[0]).isEqualTo((byte) 23);
    // The top is the third face, upside down; its lower left pixel the file's upper left.
    assertThat(cube.rgba()[4 * 16]).isEqualTo((byte) 8);

    Texture.Image volume = decode(file(RGB, 1, 1, 1, 2, 3, 4, 5, 6).putInt(28, 2));
    assertThat(volume.layers()).isEqualTo(2);
    assertThat(volume.rgba()).containsExactly(1, 2, 3, -1, 4, 5, 6, -1);
  }

  private static ByteBuffer packed(byte[] pixels, int width) {
    Deflater deflater = new Deflater();
    deflater.setInput(pixels);
    deflater.finish();
    byte[] some = new byte[pixels.length + 64];
    byte[] bytes = Arrays.copyOf(some, deflater.deflate(some));
    deflater.end();
    return file(RGB, width, 1, bytes).putInt(44, 3).putLong(96, pixels.length);
  }

  @Test
  void pixelsMayBeCompressedByZlib() throws IOException {
    assertThat(decode(packed(new byte[] {1, 2, 3}, 1)).rgba()).containsExactly(1, 2, 3, -1);
  }

  @Test
  void whatIsNotReadSaysWhatToDo() {
    assertThatThrownBy(() -> decode(file(0, 1, 1, 0))).hasMessageContaining("Basis Universal");
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putInt(44, 1)))
        .hasMessageContaining("ktx transcode");
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putInt(44, 2)))
        .hasMessageContaining("Zstandard");
    assertThatThrownBy(() -> decode(file(157, 1, 1, 1, 2, 3)))
        .hasMessageContaining("VkFormat 157 (use R8G8B8A8, BC1, BC2 or BC3)");
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putInt(32, 2)))
        .hasMessageContaining("several images");
  }

  @Test
  void whatIsDamagedOrTooLargeIsRefused() {
    String fewer = "is a damaged KTX2 image: it holds fewer pixels than it announces";
    String early = "is a damaged KTX2 image: it ends too early";
    assertThatThrownBy(() -> decode(file(RGB, 2, 1, 1, 2, 3))).hasMessage(fewer);
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putLong(88, 4))).hasMessage(early);
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putLong(80, -1L))).hasMessage(early);
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putLong(80, Long.MAX_VALUE)))
        .hasMessage(early);
    assertThatThrownBy(() -> decode(file(RGB, 1 << 30, -1, 1, 2, 3).putInt(28, -1)))
        .hasMessageContaining("more than the limit");
    assertThatThrownBy(() -> decode(file(RGB, 0, 1, 1)))
        .hasMessageContaining("its size is impossible");
    assertThatThrownBy(() -> decode(file(RGB, 1, 1, 1, 2, 3).putInt(36, 5)))
        .hasMessageContaining("its size is impossible");
    assertThatThrownBy(() -> decode(ByteBuffer.wrap(Arrays.copyOf(file(RGB, 1, 1, 1).array(), 20))))
        .isInstanceOf(IOException.class);
    ByteBuffer bomb = packed(new byte[3], 1).putInt(20, 1000).putLong(96, 3000);
    assertThatThrownBy(() -> decode(bomb)).hasMessage(early);
    ByteBuffer noise = file(RGB, 1, 1, 9, 9, 9).putInt(44, 3);
    assertThatThrownBy(() -> decode(noise)).hasMessageContaining("its pixels are no zlib data");
  }
}
