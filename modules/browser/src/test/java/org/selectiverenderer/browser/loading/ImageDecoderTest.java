package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

class ImageDecoderTest {
  @TempDir private Path folder;

  private Texture.Image decode(int type, int... argb) throws IOException {
    BufferedImage image = new BufferedImage(2, argb.length / 2, type);
    image.setRGB(0, 0, 2, argb.length / 2, argb, 0, 2);
    Path file = folder.resolve("a.png");
    ImageIO.write(image, "png", file.toFile());
    return ImageDecoder.read(
        new UrlContent.OfFile(file, file.toString()), new AtomicLong(Long.MAX_VALUE));
  }

  @Test
  void theFirstRowIsTheLowest() throws IOException {
    Texture.Image image =
        decode(BufferedImage.TYPE_INT_RGB, 0xFF010203, 0xFF040506, 0xFF070809, 0xFF0A0B0C);
    assertThat(image.rgba()).containsExactly(7, 8, 9, -1, 10, 11, 12, -1, 1, 2, 3, -1, 4, 5, 6, -1);
    assertThat(image.components()).isEqualTo(3);
  }

  @Test
  void componentsAreCountedAsTheFileHasThem() throws IOException {
    assertThat(decode(BufferedImage.TYPE_INT_ARGB, 0x80FF0000, -1).components()).isEqualTo(4);
    assertThat(decode(BufferedImage.TYPE_BYTE_GRAY, 0xFF808080, -1).components()).isEqualTo(1);
  }

  /** A pipe can be read once: whoever opens it again waits for ever. */
  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders hold no pipes")
  void aJpegIsOpenedOnce() throws Exception {
    ByteArrayOutputStream jpeg = new ByteArrayOutputStream();
    ImageIO.write(new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB), "jpeg", jpeg);
    Path pipe = folder.resolve("a.jpg");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    CompletableFuture<Texture.Image> read =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return ImageDecoder.read(
                    new UrlContent.OfFile(pipe, "a.jpg"), new AtomicLong(Long.MAX_VALUE));
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });
    Files.write(pipe, jpeg.toByteArray());
    assertThat(read.get(20, TimeUnit.SECONDS).width()).isEqualTo(8);
  }

  private Texture.Image decodeGrey(int type, int sample) throws IOException {
    BufferedImage image = new BufferedImage(1, 1, type);
    image.getRaster().setSample(0, 0, 0, sample);
    Path file = folder.resolve("grey.png");
    ImageIO.write(image, "png", file.toFile());
    return ImageDecoder.read(
        new UrlContent.OfFile(file, file.toString()), new AtomicLong(Long.MAX_VALUE));
  }

  @Test
  void greySamplesAreAsTheFileHasThem() throws IOException {
    assertThat(decodeGrey(BufferedImage.TYPE_BYTE_GRAY, 0x80).rgba())
        .containsExactly(0x80, 0x80, 0x80, -1);
    assertThat(decodeGrey(BufferedImage.TYPE_USHORT_GRAY, 0x8034).rgba())
        .containsExactly(0x80, 0x80, 0x80, -1);
  }

  @Test
  void aJpegOfFourInksIsRead() throws IOException {
    WritableRaster inks = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 8, 8, 4, null);
    for (int i = 0; i < 64; i++) {
      inks.setPixel(i % 8, i / 8, new int[] {255, 0, 0, 51});
    }
    Path file = folder.resolve("inks.jpg");
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
      writer.setOutput(out);
      writer.write(new IIOImage(inks, null, null));
    } finally {
      writer.dispose();
    }
    Texture.Image image =
        ImageDecoder.read(
            new UrlContent.OfFile(file, file.toString()), new AtomicLong(Long.MAX_VALUE));
    // Cyan, and a fifth of black.
    assertThat(image.components()).isEqualTo(3);
    assertThat(image.rgba()[0] & 0xff).isLessThan(4);
    assertThat(image.rgba()[1] & 0xff).isBetween(200, 208);
    assertThat(image.rgba()[2] & 0xff).isBetween(200, 208);
  }

  @Test
  void imagesThatWouldTakeMoreThanTheBudgetAreRefused() throws IOException {
    AtomicLong budget = new AtomicLong(60);
    Path file = folder.resolve("a.png");
    ImageIO.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    assertThat(ImageDecoder.read(new UrlContent.OfFile(file, file.toString()), budget).width())
        .isEqualTo(2);
    assertThatThrownBy(
            () -> ImageDecoder.read(new UrlContent.OfFile(file, file.toString()), budget))
        .hasMessage("has 4 pixels, for which there is not enough memory");
    assertThat(budget).hasValue(12);
  }

  @Test
  void pixelsOfOneToFourComponents() throws IOException {
    assertThat(ImageDecoder.pixels(new int[] {1, 1, 1, 0x12}).rgba())
        .containsExactly(0x12, 0x12, 0x12, -1);
    assertThat(ImageDecoder.pixels(new int[] {1, 1, 2, 0x1234}).rgba())
        .containsExactly(0x12, 0x12, 0x12, 0x34);
    assertThat(ImageDecoder.pixels(new int[] {1, 1, 3, 0x123456}).rgba())
        .containsExactly(0x12, 0x34, 0x56, -1);
    assertThat(ImageDecoder.pixels(new int[] {1, 1, 4, 0x12345678}).rgba())
        .containsExactly(0x12, 0x34, 0x56, 0x78);
  }

  @Test
  void pixelsWithoutSizeAreNoImage() {
    assertThatThrownBy(() -> ImageDecoder.pixels(new int[0])).isInstanceOf(IOException.class);
    assertThatThrownBy(() -> ImageDecoder.pixels(new int[] {1 << 20, 1 << 20, 3}))
        .isInstanceOf(IOException.class);
    assertThatThrownBy(() -> ImageDecoder.pixels(new int[] {-1, 1, 3}))
        .isInstanceOf(IOException.class);
  }
}
