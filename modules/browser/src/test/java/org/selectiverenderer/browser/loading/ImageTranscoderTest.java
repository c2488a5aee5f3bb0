package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class ImageTranscoderTest {
  private static byte[] png(String name, byte[] bytes) throws IOException {
    return ImageTranscoder.png(
        new UrlContent.OfBytes(name, name, BaseUrl.folder(Path.of("")), bytes));
  }

  private static BufferedImage read(byte[] png) throws IOException {
    assertThat(new String(png, 1, 3, StandardCharsets.US_ASCII)).isEqualTo("PNG");
    return ImageIO.read(new ByteArrayInputStream(png));
  }

  @ParameterizedTest
  @ValueSource(strings = {"gif", "bmp", "png"})
  void theImageStaysUpright(String format) throws IOException {
    // The JDK's GIF writer does not write smaller images correctly.
    BufferedImage image = new BufferedImage(16, 16, BufferedImage.TYPE_BYTE_INDEXED);
    image.setRGB(0, 0, 0xff0000);
    image.setRGB(15, 0, 0x00ff00);
    image.setRGB(0, 15, 0x0000ff);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, format, bytes);
    BufferedImage found = read(png("a." + format, bytes.toByteArray()));
    assertThat(found.getRGB(0, 0)).isEqualTo(0xffff0000);
    assertThat(found.getRGB(15, 0)).isEqualTo(0xff00ff00);
    assertThat(found.getRGB(0, 15)).isEqualTo(0xff0000ff);
  }

  @Test
  void radiancePicturesBecomeWhatIsShown() throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n".getBytes(StandardCharsets.US_ASCII));
    file.writeBytes(new byte[] {(byte) 128, 0, 0, (byte) 128});
    assertThat(read(png("sky.hdr", file.toByteArray())).getRGB(0, 0)).isEqualTo(0xffbc0000);
  }

  @Test
  void greyAndOpacityKeepTheirSamples() throws IOException {
    // TGA of 32 bits: blue, green, red, opacity
    byte[] tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 8, 1, 2, 3, 64};
    assertThat(read(png("a.tga", tga)).getRGB(0, 0)).isEqualTo(0x40030201);
    // TGA of 8 bits of grey
    byte[] grey = {0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 8, 0, 77};
    byte[] png = png("b.tga", grey);
    assertThat(png[25]).as("the colour type of grey images").isZero();
    assertThat(read(png).getRaster().getSample(0, 0, 0)).isEqualTo(77);
  }

  @Test
  void otherFilesAreRefusedWithAPredicate() {
    byte[] webp = "RIFF    WEBPVP8 ".getBytes(StandardCharsets.US_ASCII);
    assertThatThrownBy(() -> png("a.webp", webp))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("is not an image of a known format");
  }
}
