package org.selectiverenderer.browser.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class SoundFileReaderTest {
  private static final AudioFileFormat.Type[] TYPES = {
    AudioFileFormat.Type.WAVE, AudioFileFormat.Type.AIFF, AudioFileFormat.Type.AU
  };

  private static byte[] file(AudioFileFormat.Type type, AudioFormat format, int... bytes)
      throws IOException {
    byte[] data = new byte[bytes.length];
    for (int i = 0; i < bytes.length; i++) {
      data[i] = (byte) bytes[i];
    }
    int frames = data.length / format.getFrameSize();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    AudioSystem.write(
        new AudioInputStream(new ByteArrayInputStream(data), format, frames), type, out);
    return out.toByteArray();
  }

  private static AudioBuffer read(byte[] bytes, long budget) throws IOException {
    return SoundFileReader.read(content(bytes), new AtomicLong(budget)).orElseThrow();
  }

  private static UrlContent content(byte[] bytes) {
    return new UrlContent.OfBytes("key", "name", BaseUrl.folder(Path.of("")), bytes);
  }

  @Test
  void readsSixteenBitsOfAllThreeFormats() throws IOException {
    for (AudioFileFormat.Type type : TYPES) {
      AudioBuffer read =
          read(file(type, new AudioFormat(100, 16, 2, true, true), 1, 0, 255, 0, 0, 7, 2, 0), 99);
      assertThat(read.samples()).as(type.toString()).containsExactly(256, -256, 7, 512);
      assertThat(read.channels()).isEqualTo(2);
      assertThat(read.seconds()).isEqualTo(0.02, within(1e-9));
    }
  }

  @Test
  void readsEightBitsAndTheLogarithmicCodesOfTelephones() throws IOException {
    AudioBuffer eight =
        read(
            file(AudioFileFormat.Type.WAVE, new AudioFormat(50, 8, 1, false, false), 128, 255, 0),
            99);
    assertThat(eight.samples()).hasSize(3);
    assertThat((int) eight.samples()[0]).isZero();
    assertThat((int) eight.samples()[1]).isBetween(32000, 32767);
    assertThat((int) eight.samples()[2]).isBetween(-32768, -32500);
    AudioFormat law = new AudioFormat(AudioFormat.Encoding.ULAW, 8000, 8, 1, 1, 8000, false);
    assertThat(read(file(AudioFileFormat.Type.AU, law, 0xff, 0x80), 99).samples())
        .containsExactly(0, 32124);
  }

  @Test
  void keepsTheFirstTwoOfManyChannels() throws IOException {
    AudioFormat format = new AudioFormat(100, 16, 3, true, false);
    byte[] bytes = file(AudioFileFormat.Type.WAVE, format, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0);
    assertThat(read(bytes, 99).samples()).containsExactly(1, 2, 4, 5);
  }

  @Test
  void leavesOtherFormats() throws IOException {
    for (String start :
        new String[] {"", "OggS", "ID3", "MThd\0\0\0\6\0\0\0\1\0`", "RIFF    AVI "}) {
      byte[] bytes = Arrays.copyOf(start.getBytes(StandardCharsets.ISO_8859_1), 64);
      assertThat(SoundFileReader.read(content(bytes), new AtomicLong(99))).as(start).isEmpty();
    }
  }

  @Test
  void saysWhatIsWrong() throws IOException {
    AudioFormat format = new AudioFormat(100, 16, 1, true, false);
    byte[] sound = file(AudioFileFormat.Type.WAVE, format, 1, 0, 2, 0);
    assertThatThrownBy(() -> read(sound, 3)).hasMessageContaining("has too many samples");
    byte[] empty = file(AudioFileFormat.Type.WAVE, format);
    assertThatThrownBy(() -> read(empty, 99)).hasMessage("holds no sound");
    byte[] huge = Arrays.copyOf(sound, SoundFileReader.MAX_BYTES + 1);
    assertThatThrownBy(() -> read(huge, 99)).hasMessageContaining("which is the limit");
  }

  /** Nothing but a sentence comes of broken files, and soon. */
  @Test
  @Timeout(60)
  void brokenFilesAreRefused() throws IOException {
    Random random = new Random(1);
    AudioFormat format = new AudioFormat(100, 16, 1, true, false);
    for (AudioFileFormat.Type type : TYPES) {
      byte[] whole = file(type, format, 1, 0, 2, 0, 3, 0);
      for (int i = 0; i < 300; i++) {
        byte[] broken = whole.clone();
        broken[random.nextInt(broken.length)] = (byte) random.nextInt(256);
        broken[random.nextInt(broken.length)] = (byte) random.nextInt(256);
        byte[] cut = Arrays.copyOf(broken, random.nextInt(broken.length) + 1);
        try {
          SoundFileReader.read(content(cut), new AtomicLong(1 << 20))
              .ifPresent(read -> assertThat(read.frames()).isPositive());
        } catch (IOException e) {
          assertThat(e.getMessage()).doesNotContain("\n");
        }
      }
    }
  }
}
