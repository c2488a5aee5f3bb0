package org.selectiverenderer.browser.sound;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.testing.Eventually;

@Timeout(60)
class AudioPlayerTest {
  private static final AudioBuffer HALF = new AudioBuffer(new short[] {16384}, 1, SoundLine.RATE);
  private static final Voice VOICE =
      new Voice("a", HALF, 0, 1, true, 1, 4, false, new Voice.Rank(0, 0, 1));

  /** A line whose buffer holds a block. */
  private static final class FakeLine implements SoundLine {
    final BlockingQueue<byte[]> written = new ArrayBlockingQueue<>(1);
    final CountDownLatch closed = new CountDownLatch(1);

    @Override
    public boolean write(byte[] samples, int length) {
      try {
        while (closed.getCount() > 0
            && !written.offer(samples.clone(), 10, TimeUnit.MILLISECONDS)) {
          assertThat(length).isEqualTo(samples.length);
        }
        return closed.getCount() > 0;
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }

    @Override
    public void close() {
      closed.countDown();
    }
  }

  private static boolean running() {
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(thread -> thread.getName().equals("sound"));
  }

  @Test
  void writesSixteenBitsForEachEarAndCutsOffWhatIsTooLoud() throws InterruptedException {
    FakeLine line = new FakeLine();
    try (AudioPlayer speaker = new AudioPlayer(() -> line)) {
      speaker.play(List.of(VOICE));
      byte[] block = line.written.take();
      assertThat(block).hasSize(4 * AudioPlayer.BLOCK);
      for (int at = 0; at < block.length; at += 4) {
        assertThat((short) (block[at] & 0xff | block[at + 1] << 8)).isEqualTo((short) 16384);
        assertThat((short) (block[at + 2] & 0xff | block[at + 3] << 8)).isEqualTo((short) 32767);
      }
      assertThat(speaker.fault()).isEmpty();
    }
    assertThat(line.closed.getCount()).isZero();
    assertThat(running()).isFalse();
  }

  @Test
  void withoutASoundNoThreadIsStartedAndNoDeviceOpened() {
    try (AudioPlayer speaker =
        new AudioPlayer(
            () -> {
              throw new AssertionError();
            })) {
      speaker.play(List.of());
      assertThat(running()).isFalse();
    }
  }

  @Test
  void aDeviceThatGoesAwayIsToldAndEndsTheThread() throws InterruptedException {
    FakeLine line = new FakeLine();
    try (AudioPlayer speaker = new AudioPlayer(() -> line)) {
      speaker.play(List.of(VOICE));
      line.written.take();
      line.close();
      AtomicReference<Optional<String>> fault = new AtomicReference<>(Optional.empty());
      Eventually.await(
          "a fault",
          () -> {
            fault.set(speaker.fault());
            return fault.get().isPresent();
          });
      assertThat(fault.get()).contains("the sound device has stopped accepting sound");
    }
  }

  @Test
  void aMissingDeviceIsToldOnce() {
    try (AudioPlayer speaker =
        new AudioPlayer(
            () -> {
              throw new IOException("this machine has no sound device");
            })) {
      AtomicReference<Optional<String>> fault = new AtomicReference<>(Optional.empty());
      Eventually.await(
          "a fault",
          () -> {
            speaker.play(List.of(VOICE));
            fault.set(speaker.fault());
            return fault.get().isPresent();
          });
      assertThat(fault.get()).contains("this machine has no sound device");
      speaker.play(List.of(VOICE));
      assertThat(speaker.fault()).isEmpty();
    }
  }
}
