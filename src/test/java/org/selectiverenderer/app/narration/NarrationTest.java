package org.selectiverenderer.app.narration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.sound.SoundLine;
import org.selectiverenderer.testing.Eventually;

/** The audio of pages: by itself, again, and to the end of the page. */
@Timeout(60)
class NarrationTest {
  private static final long SECOND = 1_000_000_000;

  @TempDir Path folder;
  private final AtomicLong clock = new AtomicLong();
  private final List<String> told = new CopyOnWriteArrayList<>();

  /** Writes a second of a constant sound. */
  private Path wav(String name) throws IOException {
    byte[] samples = new byte[2 * 8000];
    for (int i = 1; i < samples.length; i += 2) {
      samples[i] = 64;
    }
    Path file = folder.resolve(name);
    try (AudioInputStream in =
        new AudioInputStream(
            new ByteArrayInputStream(samples), new AudioFormat(8000, 16, 1, true, false), 8000)) {
      AudioSystem.write(in, AudioFileFormat.Type.WAVE, file.toFile());
    }
    return file;
  }

  private static SoundLine none() throws IOException {
    throw new IOException("nothing is to be played");
  }

  @Test
  void aPageIsHeardOnceAgainOnDemandAndNoLongerThanItIsShown() throws IOException {
    AtomicLong loud = new AtomicLong();
    SoundLine line =
        new SoundLine() {
          @Override
          public boolean write(byte[] samples, int length) {
            for (int i = 1; i < length; i += 2) {
              if (samples[i] > 32) {
                loud.incrementAndGet();
              }
            }
            return true;
          }

          @Override
          public void close() {
            // Nothing is open.
          }
        };
    Optional<Path> audio = Optional.of(wav("a.wav"));
    try (Narration narration = new Narration(() -> line, clock::get, told::add)) {
      narration.show("one", audio);
      assertThat(narration.playing()).isTrue();
      Eventually.await("sound", () -> loud.get() > 0);
      clock.addAndGet(SECOND / 2);
      narration.show("one", audio);
      assertThat(narration.playing()).isTrue();
      clock.addAndGet(SECOND);
      narration.show("one", audio);
      assertThat(narration.playing()).as("it is not repeated by itself").isFalse();
      narration.again();
      narration.show("one", audio);
      assertThat(narration.playing()).isTrue();
      narration.show("two", Optional.empty());
      assertThat(narration.playing()).as("another page").isFalse();
      narration.show("three", audio);
      assertThat(narration.playing()).as("the same file on a further page").isTrue();
      narration.hide();
      assertThat(narration.playing()).isFalse();
    }
    assertThat(told).isEmpty();
  }

  @Test
  void withoutADeviceThereIsOneWarning() throws IOException {
    Optional<Path> audio = Optional.of(wav("a.wav"));
    try (Narration narration =
        new Narration(
            () -> {
              throw new IOException("there is no sound device");
            },
            clock::get,
            told::add)) {
      Eventually.await(
          "a warning",
          () -> {
            narration.show("one", audio);
            return !told.isEmpty();
          });
      for (int page = 0; page < 20; page++) {
        narration.show(page, audio);
      }
    }
    assertThat(told)
        .containsExactly(
            "the audio of the study cannot be played: there is no sound device; the session goes"
                + " on without it");
  }

  @Test
  void aFileThatCannotBeReadIsToldOnceAndThePageIsSilent() throws IOException {
    Path text = Files.writeString(folder.resolve("text.wav"), "no sound");
    Path gone = folder.resolve("gone.wav");
    try (Narration narration = SilentNarration.make()) {
      narration.show("one", Optional.of(text));
    }
    List<Object> pages = new ArrayList<>(List.of(1, 2, 3));
    try (Narration narration = new Narration(NarrationTest::none, clock::get, told::add)) {
      pages.forEach(page -> narration.show(page, Optional.of(text)));
      pages.forEach(page -> narration.show(page, Optional.of(gone)));
      assertThat(narration.playing()).isFalse();
    }
    assertThat(told)
        .hasSize(2)
        .first()
        .isEqualTo("the audio " + text + " has a format that cannot be played");
    assertThat(told.get(1)).startsWith("the audio " + gone + " ");
  }
}
