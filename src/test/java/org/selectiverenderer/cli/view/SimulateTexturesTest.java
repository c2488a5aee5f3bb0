package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A texture that cannot be had is told; its shape is shown without. */
class SimulateTexturesTest {
  @TempDir private Path temp;
  private SimulateTestCase folder;

  @BeforeEach
  void writePath() {
    folder = new SimulateTestCase(temp);
  }

  private static String textured(String texture) {
    return "<Shape><Appearance>" + texture + "</Appearance><Box/></Shape>\n";
  }

  private void assertLeftOut(String texture, String message) {
    SimulateTestCase.Result result =
        folder.scene("scene.x3d", textured(texture)).simulate("scene.x3d");
    assertThat(result.messages())
        .containsExactly("scene.x3d:2:20: " + message + "; the texture is left out");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  private static String image(String url) {
    return "<ImageTexture url='\"" + url + "\"'/>";
  }

  private static byte[] png(int width, int height) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), "png", bytes);
    return bytes.toByteArray();
  }

  @Test
  void aTextureThatIsThereIsNoProblem() throws IOException {
    folder.write("a.png", png(3, 2)).scene("scene.x3d", textured(image("a.png")));
    assertThat(folder.simulate("scene.x3d").messages()).isEmpty();
    assertThat(folder.simulate("scene.x3d").status()).isZero();
  }

  @Test
  void aTextureThatIsMissingIsLeftOut() {
    assertLeftOut(image("no.png"), "ImageTexture url 'no.png' is missing");
    assertLeftOut(
        image("http://example.org/a.png"),
        "ImageTexture url 'http://example.org/a.png' is on the network; --allow-net"
            + " example.org would allow it");
    assertLeftOut(
        image("../a.png"),
        "ImageTexture url '../a.png' points outside the folders this scene may name; --allow "
            + folder.path("..").normalize().toString().replace('\\', '/')
            + " would allow it");
  }

  @Test
  void aTextureThatIsNoImageIsLeftOut() {
    folder.write("a.png", "<svg/>").write("empty.png", "");
    assertLeftOut(
        image("a.png"),
        "a.png is not an image of a known format (PNG, JPEG, GIF, BMP, TGA, DDS, KTX2 or HDR)");
    assertLeftOut(
        image("empty.png"),
        "empty.png is not an image of a known format (PNG, JPEG, GIF, BMP, TGA, DDS, KTX2 or HDR)");
  }

  @Test
  void anImageThatIsCutOffIsLeftOutWhereverItEnds() throws IOException {
    byte[] whole = png(64, 64);
    for (int length = 8; length < whole.length - 50; length += 3) {
      folder.write("cut.png", Arrays.copyOf(whole, length));
      assertLeftOut(image("cut.png"), "cut.png is a damaged image");
    }
  }

  @Test
  void anImageOfManyPixelsIsLeftOutBeforeMemoryIsSpentOnIt() throws IOException {
    folder.write("huge.png", withSize(png(4, 4), 100_000, 90_000));
    assertLeftOut(
        image("huge.png"), "huge.png has 9000000000 pixels, more than the limit of 67108864");
    folder.write("negative.png", withSize(png(4, 4), -1, 4));
    assertLeftOut(image("negative.png"), "negative.png is a damaged image");
  }

  /** A PNG that claims to be of another size (PNG specification, 11.2.2: IHDR). */
  private static byte[] withSize(byte[] png, int width, int height) {
    ByteBuffer bytes = ByteBuffer.wrap(png.clone());
    bytes.putInt(16, width).putInt(20, height);
    CRC32 crc = new CRC32();
    crc.update(bytes.array(), 12, 17);
    bytes.putInt(29, (int) crc.getValue());
    return bytes.array();
  }

  @Test
  void aPixelTextureWithTooFewPixelsIsLeftOut() {
    folder.scene("scene.x3d", textured("<PixelTexture image='1000 1000 3 0xFF0000'/>"));
    SimulateTestCase.Result result = folder.simulate("scene.x3d");
    assertThat(result.messages())
        .containsExactly(
            "scene.x3d:2:20: the image of the PixelTexture contains no image: it "
                + "needs width, height and 1 to 4 components; the texture is left out",
            "scene.x3d:2:41: image: the image has only 1 of its 1000000 pixels; its first 0 rows"
                + " are shown");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void eachTextureThatNamesABadFileSaysSo() {
    folder.write("a.png", "no".getBytes(StandardCharsets.UTF_8));
    folder.scene("scene.x3d", textured(image("a.png")) + textured(image("a.png")));
    assertThat(folder.simulate("scene.x3d").messages())
        .containsExactly(
            "scene.x3d:2:20: a.png is not an image of a known format (PNG, JPEG, GIF, "
                + "BMP, TGA, DDS, KTX2 or HDR); the texture is left out",
            "scene.x3d:3:20: a.png is not an image of a known format (PNG, JPEG, GIF, "
                + "BMP, TGA, DDS, KTX2 or HDR); the texture is left out");
  }
}
