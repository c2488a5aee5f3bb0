package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

class PngDecoderTest {
  private static final int WIDTH = 13;
  private static final int HEIGHT = 20;

  @TempDir private Path folder;

  /** Rows of random samples behind every filter of the format in turn. */
  private static byte[] rows(int samples) {
    byte[] rows = new byte[(1 + WIDTH * samples) * HEIGHT];
    new Random(samples).nextBytes(rows);
    for (int y = 0; y < HEIGHT; y++) {
      rows[y * (1 + WIDTH * samples)] = (byte) (y % 5);
    }
    return rows;
  }

  private static byte[] deflated(byte[] data) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
      deflater.write(data);
    }
    return out.toByteArray();
  }

  private static void chunk(ByteArrayOutputStream out, String type, byte[] data) {
    CRC32 crc = new CRC32();
    crc.update(type.getBytes(StandardCharsets.US_ASCII));
    crc.update(data);
    out.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
    out.writeBytes(type.getBytes(StandardCharsets.US_ASCII));
    out.writeBytes(data);
    out.writeBytes(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
  }

  /** A file whose data is in two chunks, behind one that says nothing about the pixels. */
  private static byte[] file(int type, byte[] deflated, String extra, byte... content) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
    ByteBuffer header = ByteBuffer.allocate(13).putInt(WIDTH).putInt(HEIGHT);
    chunk(out, "IHDR", header.put(new byte[] {8, (byte) type, 0, 0, 0}).array());
    chunk(out, extra, content);
    int middle = deflated.length / 2;
    chunk(out, "IDAT", Arrays.copyOfRange(deflated, 0, middle));
    chunk(out, "IDAT", Arrays.copyOfRange(deflated, middle, deflated.length));
    chunk(out, "IEND", new byte[0]);
    return out.toByteArray();
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "4, 2", "2, 3", "6, 4"})
  void samplesOfEveryFilterAreThoseThatTheLibraryReads(int type, int samples) throws IOException {
    byte[] file = file(type, deflated(rows(samples)), "tEXt", (byte) 'a', (byte) 0);
    Texture.Image image = PngDecoder.of(file).orElseThrow().decode().orElseThrow();
    assertThat(image.width()).isEqualTo(WIDTH);
    assertThat(image.height()).isEqualTo(HEIGHT);
    assertThat(image.components()).isEqualTo(samples);
    Raster raster = ImageIO.read(new ByteArrayInputStream(file)).getRaster();
    int[] expected = new int[samples];
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        raster.getPixel(x, y, expected);
        int at = 4 * ((HEIGHT - 1 - y) * WIDTH + x);
        int[] found = new int[samples];
        for (int i = 0; i < samples; i++) {
          boolean alpha = samples % 2 == 0 && i == samples - 1;
          found[i] = image.rgba()[at + (alpha ? 3 : i)] & 0xff;
        }
        assertThat(found).as("pixel %d %d", x, y).isEqualTo(expected);
        if (samples % 2 == 1) {
          assertThat(image.rgba()[at + 3]).isEqualTo((byte) 255);
        }
      }
    }
  }

  @Test
  void aTransparentColourIsLeftToTheLibrary() throws IOException {
    byte[] file = file(2, deflated(rows(3)), "tRNS", new byte[6]);
    assertThat(PngDecoder.of(file).orElseThrow().decode()).isEmpty();
  }

  /** Every number of the palette occurs. */
  private static byte[] indexed(int colours, boolean grey) throws IOException {
    byte[] rows = new byte[(1 + WIDTH) * HEIGHT];
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        rows[y * (1 + WIDTH) + 1 + x] = (byte) (y * WIDTH + x & 0xff);
      }
    }
    byte[] palette = new byte[3 * colours];
    for (int i = 0; i < palette.length; i++) {
      palette[i] = (byte) (grey ? i / 3 : 7 * i);
    }
    return file(3, deflated(rows), "PLTE", palette);
  }

  @Test
  void numbersOfAPaletteBecomeItsColours() throws IOException {
    byte[] file = indexed(256, false);
    Texture.Image image = PngDecoder.of(file).orElseThrow().decode().orElseThrow();
    BufferedImage expected = ImageIO.read(new ByteArrayInputStream(file));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      int at = 4 * ((HEIGHT - 1 - i / WIDTH) * WIDTH + i % WIDTH);
      int found =
          (image.rgba()[at + 3] & 0xff) << 24
              | (image.rgba()[at] & 0xff) << 16
              | (image.rgba()[at + 1] & 0xff) << 8
              | image.rgba()[at + 2] & 0xff;
      assertThat(found).isEqualTo(expected.getRGB(i % WIDTH, i / WIDTH));
    }
    assertThat(image.components()).isEqualTo(3);
    assertThat(PngDecoder.of(indexed(256, true)).orElseThrow().decode().orElseThrow().components())
        .isEqualTo(1);
  }

  @Test
  void aNumberThatThePaletteHasNotIsLeftToTheLibrary() throws IOException {
    assertThat(PngDecoder.of(indexed(255, false)).orElseThrow().decode()).isEmpty();
  }

  @Test
  void otherKindsAreLeftToTheLibrary() throws IOException {
    BufferedImage bits = new BufferedImage(4, 4, BufferedImage.TYPE_BYTE_BINARY);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(bits, "png", out);
    assertThat(PngDecoder.of(out.toByteArray())).isEmpty();
    assertThat(PngDecoder.of(new byte[0])).isEmpty();
    assertThat(PngDecoder.of("GIF89a".getBytes(StandardCharsets.US_ASCII))).isEmpty();
  }

  @Test
  void damageIsLeftToTheLibraryAndCostsNoMemoryOfTheBudget() throws IOException {
    byte[] whole = deflated(rows(3));
    byte[] unknown = rows(3);
    unknown[0] = 9;
    for (byte[] data :
        new byte[][] {new byte[10], deflated(unknown), Arrays.copyOf(whole, whole.length / 2)}) {
      byte[] file = file(2, data, "tEXt", (byte) 'a', (byte) 0);
      assertThat(PngDecoder.of(file).orElseThrow().decode()).isEmpty();
    }
    Path path = folder.resolve("a.png");
    Files.write(path, file(2, deflated(rows(3)), "tRNS", new byte[6]));
    AtomicLong budget = new AtomicLong(12L * WIDTH * HEIGHT);
    Texture.Image image = ImageDecoder.read(new UrlContent.OfFile(path, path.toString()), budget);
    assertThat(image.components()).isEqualTo(4);
    assertThat(budget).hasValue(0);
  }
}
