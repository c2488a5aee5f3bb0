package org.selectiverenderer.browser.movie.mpeg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class MpegVideoTest {
  private static final Path FOLDER =
      Path.of("modules/browser/src/test/resources/org/selectiverenderer/browser/movie");

  private static byte[] file(String name) throws IOException {
    return Files.readAllBytes(FOLDER.resolve(name));
  }

  private static List<byte[]> all(MpegVideo video) {
    MpegDecoder decoder = video.decoder();
    List<byte[]> pictures = new ArrayList<>();
    for (int i = 0; i < video.pictures(); i++) {
      pictures.add(decoder.picture(i));
    }
    return pictures;
  }

  @Test
  void picturesAreThoseThatAnotherDecoderMakes() throws IOException {
    MpegVideo video = MpegVideo.of(file("mandelbrot.m1v"));
    BufferedImage other = ImageIO.read(new ByteArrayInputStream(file("mandelbrot-0-4-12.png")));
    List<byte[]> pictures = all(video);
    int[] chosen = {0, 4, 12}; // A whole one, one between two, and the last of a chain.

    assertThat(pictures).hasSize(13);
    assertThat(video.rate()).isEqualTo(25);
    for (int i = 0; i < chosen.length; i++) {
      byte[] rgba = pictures.get(chosen[i]);
      double sum = 0;
      for (int y = 0; y < 40; y++) {
        for (int x = 0; x < 56; x++) {
          int rgb = other.getRGB(56 * i + x, y);
          int at = 4 * (56 * (39 - y) + x);
          for (int c = 0; c < 3; c++) {
            int off = (rgba[at + c] & 255) - (rgb >> 16 - 8 * c & 255);
            sum += off * off;
          }
        }
      }
      // The others mix colours between pixels a little.
      assertThat(Math.sqrt(sum / (56 * 40 * 3))).as("picture %s", chosen[i]).isLessThan(6);
    }
  }

  @Test
  void pictureIsTheSameInAnyOrder() throws IOException {
    MpegVideo video = MpegVideo.of(file("mandelbrot.m1v"));
    List<byte[]> pictures = all(video);
    MpegDecoder decoder = video.decoder();

    for (int i = 12; i >= 0; i--) {
      assertThat(decoder.picture(i)).as("picture %s", i).isEqualTo(pictures.get(i));
    }
    for (int i = 0; i < 13; i++) {
      int far = i * 5 % 13;
      assertThat(decoder.picture(far)).as("picture %s", far).isEqualTo(pictures.get(far));
    }
  }

  @Test
  void streamHoldsTheSamePictures() throws IOException {
    byte[] video = file("mandelbrot.m1v");
    MpegVideo alone = MpegVideo.of(video);

    MpegVideo streamed = MpegVideo.of(stream(video));

    assertThat(all(streamed)).usingElementComparator(Arrays::compare).isEqualTo(all(alone));
  }

  @Test
  void whatIsCutOffIsKnownWhereverItIsCut() throws IOException {
    byte[] whole = file("mandelbrot.m1v");
    MpegVideo video = MpegVideo.of(whole);
    assertThat(video.cutOff()).isFalse();
    assertThat(MpegVideo.of(stream(whole)).cutOff()).isFalse();
    int last = video.start(video.pictures() - 1);
    // This one has no code that ends the sequence, as not all programs write one.
    byte[] ended = Arrays.copyOf(whole, whole.length + 4);
    System.arraycopy(new byte[] {0, 0, 1, (byte) 0xb7}, 0, ended, whole.length, 4);
    assertThat(MpegVideo.of(ended).cutOff()).isFalse();
    assertThat(MpegVideo.of(Arrays.copyOf(whole, last)).cutOff()).isFalse();
    for (int length = last + 8; length < whole.length - 1; length += 5) {
      byte[] cut = Arrays.copyOf(whole, length);
      assertThat(MpegVideo.of(cut).cutOff()).as("%s of %s bytes", length, whole.length).isTrue();
    }
  }

  /**
   * A system stream: a pack, then packets of video with and without stamps, one of sound between.
   */
  private static byte[] stream(byte[] video) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(new byte[] {0, 0, 1, (byte) 0xba, 0x21, 0, 1, 0, 1, (byte) 0x80, 0, 1});
    byte[][] headers = {
      {0x21, 0, 1, 0, 1},
      {(byte) 0xff, (byte) 0xff, 0x0f},
      {0x60, 4, 0x31, 0, 1, 0, 1, 0x11, 0, 1, 0, 1}
    };
    for (int at = 0, i = 0; at < video.length; at += 100, i++) {
      byte[] header = headers[i % headers.length];
      int length = Math.min(100, video.length - at);
      packet(out, 0xe0, header, Arrays.copyOfRange(video, at, at + length));
      packet(out, 0xc0, header, new byte[20]);
    }
    out.writeBytes(new byte[] {0, 0, 1, (byte) 0xb9});
    return out.toByteArray();
  }

  private static void packet(ByteArrayOutputStream out, int stream, byte[] header, byte[] data) {
    int length = header.length + data.length;
    out.writeBytes(new byte[] {0, 0, 1, (byte) stream, (byte) (length >> 8), (byte) length});
    out.writeBytes(header);
    out.writeBytes(data);
  }

  @Test
  void damagedVideoStillGivesPicturesOrSaysWhyNot() throws IOException {
    byte[] whole = file("mandelbrot.m1v");
    Random random = new Random(1);
    int decoded = 0;
    for (int round = 0; round < 200; round++) {
      byte[] damaged = Arrays.copyOf(whole, whole.length - random.nextInt(whole.length / 2));
      for (int i = 0; i < 20; i++) {
        damaged[40 + random.nextInt(damaged.length - 40)] = (byte) random.nextInt();
      }
      try {
        MpegVideo video = MpegVideo.of(damaged);
        for (byte[] picture : all(video)) {
          assertThat(picture).hasSize(4 * 56 * 40);
        }
        decoded++;
      } catch (IOException e) {
        assertThat(e).hasMessageMatching("holds no .*|is MPEG-2 .*");
      }
    }
    assertThat(decoded).isGreaterThan(100);
  }

  @Test
  void otherVideoIsTold() {
    assertThatThrownBy(() -> MpegVideo.of(file("two-red.m2v")))
        .hasMessage("is MPEG-2 video; only MPEG-1 video is supported");
    assertThatThrownBy(() -> MpegVideo.of(new byte[] {0, 0, 1, (byte) 0xba, 0, 0, 0, 0}))
        .hasMessage("holds no video");
  }

  @Test
  void filmHasNotMorePicturesThanThereIsMemoryFor() throws IOException {
    byte[] header = {0, 0, 1, (byte) 0xb3, 1, 0, 0x10, 0x13, -1, -1, (byte) 0xe0, 0x18};
    byte[] many = Arrays.copyOf(header, header.length + 6 * (MpegVideo.MOST + 9));
    for (int at = header.length; at < many.length; at += 6) {
      many[at + 2] = 1;
      many[at + 5] = MpegVideo.WHOLE << 3;
    }

    assertThat(MpegVideo.of(many).pictures()).isEqualTo(MpegVideo.MOST);
  }

  @Test
  void slicesThatSayThePictureOverAndOverArePassedOver() throws IOException {
    byte[] film = file("mandelbrot.m1v");
    int picture = place(film, 0, 0);
    int slices = place(film, picture + 4, 1);
    int end = place(film, slices, 0);
    byte[] once = Arrays.copyOf(film, end);
    byte[] again = Arrays.copyOfRange(film, slices, end);
    ByteArrayOutputStream three = new ByteArrayOutputStream();
    three.writeBytes(once);
    three.writeBytes(again);
    again[4] ^= 0x40; // Another quantizer, which the picture shows where it counts.
    three.writeBytes(again);
    ByteArrayOutputStream two = new ByteArrayOutputStream();
    two.writeBytes(once);
    two.writeBytes(again);

    assertThat(first(two.toByteArray())).isNotEqualTo(first(once));
    assertThat(first(three.toByteArray())).isEqualTo(first(once));
  }

  private static byte[] first(byte[] film) throws IOException {
    return MpegVideo.of(film).decoder().picture(0);
  }

  /** Where the start code of a kind stands. */
  private static int place(byte[] film, int from, int code) {
    int at = MpegVideo.next(film, from);
    while ((film[at + 3] & 255) != code) {
      at = MpegVideo.next(film, at + 4);
    }
    return at;
  }
}
