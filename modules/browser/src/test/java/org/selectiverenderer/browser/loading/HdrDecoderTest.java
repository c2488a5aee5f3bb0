package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class HdrDecoderTest {
  private static final String FORMAT = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

  /** Returns a file of a text and the bytes that follow. */
  private static byte[] file(String head, int... pixels) {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(head.getBytes(StandardCharsets.US_ASCII));
    Arrays.stream(pixels).forEach(file::write);
    return file.toByteArray();
  }

  private static Texture.Image decode(byte[] file) throws IOException {
    UrlContent content = new UrlContent.OfBytes("a", "a.hdr", BaseUrl.folder(Path.of("")), file);
    return ImageDecoder.read(content, new AtomicLong(Long.MAX_VALUE));
  }

  private static Texture.Image decode(String size, int... pixels) throws IOException {
    return decode(file(FORMAT + size + "\n", pixels));
  }

  @Test
  void lightUpToFourFifthsIsKeptAndWhatIsBrighterIsCompressed() throws IOException {
    // 128/256 of 2^0, black, 128/256 of 2^1 = 1 and 2^4 = 16 with a quarter of it in green.
    Texture.Image image =
        decode(
            "-Y 1 +X 4",
            new int[] {128, 128, 128, 128, 9, 9, 9, 0, 128, 0, 0, 129, 128, 32, 0, 133});
    assertThat(image.components()).isEqualTo(3);
    // sRGB of 0.5; 0; of 1 - 0.04 / 0.4; of 1 - 0.04 / 15.4 and a quarter of it.
    assertThat(image.rgba())
        .containsExactly(-68, -68, -68, -1, 0, 0, 0, -1, -13, 0, 0, -1, -1, -119, 0, -1);
  }

  @Test
  void theSizesLineSaysWhereTheFirstRowIs() throws IOException {
    int[] two = {128, 0, 0, 128, 0, 128, 0, 128};
    assertThat(decode("-Y 2 +X 1", two).rgba()).startsWith(0, -68, 0, -1, -68);
    assertThat(decode("+Y 2 +X 1", two).rgba()).startsWith(-68, 0, 0, -1, 0);
    assertThat(decode("-Y 1 -X 2", two).rgba()).startsWith(0, -68, 0, -1, -68);
    assertThatThrownBy(() -> decode("+X 1 -Y 2", two)).hasMessageContaining("stored by columns");
  }

  @Test
  void rowsInEitherRunLengthEncodingAreTheSame() throws IOException {
    Texture.Image plain =
        decode(
            "-Y 1 +X 8",
            new int[] {
              9, 8, 7, 128, 9, 8, 7, 128, 9, 8, 7, 128, 9, 8, 7, 128, 9, 8, 7, 128, 9, 8, 7, 128, 9,
              8, 7, 128, 5, 8, 7, 128
            });
    Texture.Image older = decode("-Y 1 +X 8", 9, 8, 7, 128, 1, 1, 1, 6, 5, 8, 7, 128);
    Texture.Image newer =
        decode(
            "-Y 1 +X 8",
            new int[] {2, 2, 0, 8, 128 + 7, 9, 1, 5, 128 + 8, 8, 4, 7, 7, 7, 7, 132, 7, 136, 128});
    assertThat(older.rgba()).isEqualTo(plain.rgba());
    assertThat(newer.rgba()).isEqualTo(plain.rgba());
  }

  @Test
  void aLongRunOfTheOlderEncodingHasSeveralCounts() throws IOException {
    // One pixel, then 4 + 256 more.
    Texture.Image image = decode("-Y 1 +X 261", 128, 0, 0, 128, 1, 1, 1, 4, 1, 1, 1, 1);
    assertThat(image.rgba()).hasSize(4 * 261).endsWith(-68, 0, 0, -1);
  }

  @Test
  void whatIsDamagedOrTooLargeIsRefused() {
    assertThatThrownBy(() -> decode("-Y 2 +X 2", 1, 2, 3, 128)).hasMessage(tooEarly());
    assertThatThrownBy(() -> decode("-Y 1 +X 8", 2, 2, 0, 8, 255, 9))
        .hasMessageContaining("a row is longer than the picture");
    assertThatThrownBy(() -> decode("-Y 1 +X 8", 2, 2, 0, 8, 0))
        .hasMessageContaining("a row is longer than the picture");
    assertThatThrownBy(() -> decode("-Y 1 +X 2", 1, 1, 1, 9))
        .hasMessageContaining("a row is longer than the picture");
    assertThatThrownBy(() -> decode("-Y 1 +X 2", 9, 9, 9, 9, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0))
        .hasMessage(tooEarly());
    assertThatThrownBy(() -> decode("-Y 999999999 +X 999999999"))
        .hasMessageContaining("more than the limit");
    assertThatThrownBy(() -> decode("-Y 0 +X 4")).hasMessageContaining("its width or height is 0");
    assertThatThrownBy(() -> decode(file("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n")))
        .hasMessageContaining("XYZ or unknown colours");
    assertThatThrownBy(() -> decode(file("#?RADIANCE"))).hasMessage(tooEarly());
    assertThatThrownBy(() -> decode(file("#?RADIANCE\n" + "x".repeat(1 << 17))))
        .hasMessage(tooEarly());
  }

  private static String tooEarly() {
    return "is a damaged Radiance picture: it ends too early";
  }

  @Test
  void aPanoramaIsACubeMapWhoseFrontIsItsMiddle() throws IOException {
    // Four columns: back left, front left, front right, back right; two rows.
    int[] pixels = new int[32];
    for (int i = 0; i < 8; i++) {
      pixels[4 * i + i % 3] = 128;
      pixels[4 * i + 3] = 128;
    }
    Texture.Image cube = CubeFaces.ofPanorama(decode("-Y 2 +X 4", pixels));
    assertThat(cube.layers()).isEqualTo(6);
    assertThat(cube.width()).isEqualTo(1);
    // The front's middle lies on the border of the columns; of the rows the upper one is taken.
    assertThat(cube.rgba()).hasSize(24).startsWith(0, 0, -68, -1);
  }
}
