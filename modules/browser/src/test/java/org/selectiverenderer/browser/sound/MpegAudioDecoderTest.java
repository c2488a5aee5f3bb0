package org.selectiverenderer.browser.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class MpegAudioDecoderTest {
  private static final int BUDGET = 1 << 20;

  /** The bytes of the tag and of the first header of each file. */
  private static final int HEAD = 100;

  private static byte[] resource(String name) throws IOException {
    try (InputStream in = MpegAudioDecoderTest.class.getResourceAsStream(name)) {
      return in.readAllBytes();
    }
  }

  private static AudioBuffer read(byte[] bytes, long budget) throws IOException {
    UrlContent file = new UrlContent.OfBytes("key", "name", BaseUrl.folder(Path.of("")), bytes);
    return SoundFileReader.read(file, new AtomicLong(budget)).orElseThrow();
  }

  /** Asserts that the middle of a sound is a tone of 441 Hz: 4.41 cycles of it in 10 ms. */
  private static void assertTone(AudioBuffer sound, int channel) {
    int rises = 0;
    int middle = sound.frames() / 2;
    for (int i = middle; i < middle + sound.rate() / 10; i++) {
      short before = sound.samples()[(i - 1) * sound.channels() + channel];
      short now = sound.samples()[i * sound.channels() + channel];
      rises += before < 0 && now >= 0 ? 1 : 0;
    }
    assertThat(rises).isBetween(43, 45);
  }

  @Test
  void layersTwoAndThreeAreTones() throws IOException {
    AudioBuffer three = read(resource("tone.mp3"), BUDGET);
    assertThat(three.channels()).isEqualTo(1);
    assertThat(three.rate()).isEqualTo(44_100);
    assertThat(three.seconds()).isEqualTo(0.3, within(0.1));
    assertTone(three, 0);
    AudioBuffer two = read(resource("tone.mp2"), BUDGET);
    assertThat(two.channels()).isEqualTo(2);
    assertThat(two.seconds()).isEqualTo(0.3, within(0.1));
    assertTone(two, 0);
    assertTone(two, 1);
  }

  @Test
  void whatIsNoWholeFrameIsPassedOver() throws IOException {
    byte[] whole = resource("tone.mp2");
    AudioBuffer sound = read(whole, BUDGET);
    byte[] tagged = Arrays.copyOf(whole, whole.length + 128);
    tagged[whole.length] = 'T';
    assertThat(read(tagged, BUDGET).samples()).isEqualTo(sound.samples());

    AudioBuffer cut = read(Arrays.copyOf(whole, whole.length - 10), BUDGET);
    assertThat(cut.frames()).isEqualTo(sound.frames() - 1152);
    assertThat(cut.samples())
        .isEqualTo(Arrays.copyOf(sound.samples(), sound.samples().length - 2 * 1152));
  }

  @Test
  void theMemoryForSamplesIsAskedForBeforeTheyAreDecoded() throws IOException {
    byte[] whole = resource("tone.mp2");
    long needed = 2L * read(whole, BUDGET).samples().length;
    AtomicLong budget = new AtomicLong(needed);
    SoundFileReader.mpegAudio(whole, budget);
    assertThat(budget).hasValue(0);
    assertThatThrownBy(() -> read(whole, needed - 1)).hasMessageContaining("too many samples");
  }

  @Test
  void theLowRatesOfMpeg2AreRead() throws IOException {
    AudioBuffer low = read(resource("mpeg2.mp3"), BUDGET);
    assertThat(low.rate()).isEqualTo(22_050);
    assertThat(low.seconds()).isEqualTo(0.2, within(0.1));
    assertTone(low, 0);
  }

  @Test
  void aDamagedFrameIsSilentAndTheOthersAreHeard() throws IOException {
    byte[] whole = resource("tone.mp2");
    AudioBuffer sound = read(whole, BUDGET);
    byte[] damaged = whole.clone();
    int frame = 144 * 64_000 / 44_100; // the length in bytes, without padding
    Arrays.fill(damaged, 3 * frame + 10, 4 * frame - 10, (byte) 0xff);
    AudioBuffer heard = read(damaged, BUDGET);
    assertThat(heard.frames()).isEqualTo(sound.frames());
    assertThat(Arrays.copyOf(heard.samples(), 2 * 2 * 1152))
        .isEqualTo(Arrays.copyOf(sound.samples(), 2 * 2 * 1152));
  }

  @Test
  void whatOnlyBeginsLikeAFrameHasNoSound() throws IOException {
    assertThatThrownBy(() -> read(new byte[] {-1, -5, (byte) 0x90, 0}, BUDGET))
        .hasMessage("holds no sound");
    UrlContent ogg =
        new UrlContent.OfBytes("key", "name", BaseUrl.folder(Path.of("")), resource("tone.ogg"));
    assertThat(SoundFileReader.read(ogg, new AtomicLong(BUDGET))).isEmpty();
  }

  @Test
  void damagedFilesAreReadOrRefusedInASentence() throws IOException {
    Random random = new Random(3);
    for (String name : new String[] {"tone.mp3", "tone.mp2"}) {
      byte[] whole = resource(name);
      for (int attempt = 0; attempt < 200; attempt++) {
        byte[] damaged = whole.clone(); // but for the first header, by which it is recognised
        for (int i = random.nextInt(20); i >= 0; i--) {
          damaged[HEAD + random.nextInt(damaged.length - HEAD)] = (byte) random.nextInt(256);
        }
        try {
          AudioBuffer sound = read(damaged, BUDGET);
          assertThat(sound.frames()).isPositive();
        } catch (IOException e) {
          assertThat(e).hasMessageMatching("is damaged: .*|holds no sound|has too many samples.*");
        }
      }
    }
  }
}
