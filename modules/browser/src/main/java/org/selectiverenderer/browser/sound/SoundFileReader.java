package org.selectiverenderer.browser.sound;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Reads WAV, AIFF and AU files, as far as the Java Sound API supports them, and MPEG audio such as
 * MP3.
 */
public final class SoundFileReader {
  /** Largest size in bytes of a file, and of its decoded samples. */
  public static final int MAX_BYTES = 32 << 20;

  /** Largest number of channels; a damaged header may claim more. */
  private static final int MAX_CHANNELS = 64;

  private static final int SOME_FRAMES = 4096;
  private static final double MAX_RATE = 400_000;

  private SoundFileReader() {}

  /**
   * Reads a file.
   *
   * @param budget the bytes left for all recordings of a load; reduced by this one
   * @return the recording; empty if the file is of another format
   * @throws IOException with a clause as message that follows the file's name
   */
  public static Optional<AudioBuffer> read(UrlContent file, AtomicLong budget) throws IOException {
    byte[] bytes = file.bytes(MAX_BYTES);
    if (MpegFrames.begins(bytes)) {
      return Optional.of(MpegAudioDecoder.decode(bytes, budget));
    }
    if (!known(bytes)) {
      return Optional.empty();
    }
    try (AudioInputStream in = AudioSystem.getAudioInputStream(new ByteArrayInputStream(bytes))) {
      return Optional.of(decode(in, budget));
    } catch (UnsupportedAudioFileException e) {
      return Optional.empty();
    } catch (RuntimeException e) { // Java's readers do not validate numbers in a file.
      throw new IOException("is damaged: " + e.getMessage(), e);
    }
  }

  /**
   * Decodes a stream of MPEG audio, such as the soundtrack of a movie.
   *
   * @param budget the bytes left for all recordings of a load; reduced by this one
   * @throws IOException with a clause as message that follows the name of the sound
   */
  public static AudioBuffer mpegAudio(byte[] stream, AtomicLong budget) throws IOException {
    return MpegAudioDecoder.decode(stream, budget);
  }

  /**
   * Returns whether a file is WAV, AIFF or AU by its signature. Java would also read MIDI, and
   * render it to an unbounded stream.
   */
  private static boolean known(byte[] bytes) {
    return has(bytes, 0, "RIFF") && has(bytes, 8, "WAVE")
        || has(bytes, 0, "FORM") && (has(bytes, 8, "AIFF") || has(bytes, 8, "AIFC"))
        || has(bytes, 0, ".snd");
  }

  private static boolean has(byte[] bytes, int at, String word) {
    return bytes.length >= at + word.length()
        && new String(bytes, at, word.length(), StandardCharsets.ISO_8859_1).equals(word);
  }

  private static AudioBuffer decode(AudioInputStream in, AtomicLong budget)
      throws IOException, UnsupportedAudioFileException {
    AudioFormat given = in.getFormat();
    float rate = given.getSampleRate();
    int channels = given.getChannels();
    if (!(rate >= 1 && rate <= MAX_RATE) || channels < 1 || channels > MAX_CHANNELS) {
      throw new IOException(
          "has an unsupported format: %s channels at %s samples per second"
              .formatted(channels, rate));
    }
    AudioFormat pcm =
        new AudioFormat(
            AudioFormat.Encoding.PCM_SIGNED, rate, 16, channels, 2 * channels, rate, false);
    if (!AudioSystem.isConversionSupported(pcm, given)) {
      throw new UnsupportedAudioFileException(given.toString());
    }
    try (AudioInputStream decoded = AudioSystem.getAudioInputStream(pcm, in)) {
      byte[] bytes = read(decoded);
      int kept = Math.min(2, channels);
      int frames = bytes.length / (2 * channels);
      check(bytes.length);
      spend(2L * kept * frames, budget);
      if (frames == 0) {
        throw new IOException("holds no sound");
      }
      return new AudioBuffer(samples(bytes, frames, channels, kept), kept, rate);
    }
  }

  /**
   * Takes the memory for samples from a budget.
   *
   * @throws IOException with a clause as message if a sound may not have so many
   */
  static void spend(long bytes, AtomicLong budget) throws IOException {
    check(bytes);
    if (budget.addAndGet(-bytes) < 0) {
      budget.addAndGet(bytes); // smaller sounds may still fit
      throw tooMany();
    }
  }

  /**
   * Checks the size of a sound's samples.
   *
   * @throws IOException with a clause as message if a sound may not have so many
   */
  static void check(long bytes) throws IOException {
    if (bytes > MAX_BYTES) {
      throw tooMany();
    }
  }

  private static IOException tooMany() {
    return new IOException(
        "has too many samples: a sound may take %s MB, and all together an eighth of the memory"
            .formatted(MAX_BYTES >> 20));
  }

  /**
   * Reads a stream to its end. For a damaged file Java's stream may return 0 bytes for ever, which
   * is treated as the end.
   */
  private static byte[] read(AudioInputStream in) throws IOException {
    ByteArrayOutputStream read = new ByteArrayOutputStream();
    byte[] some = new byte[SOME_FRAMES * in.getFormat().getFrameSize()];
    for (int count = in.read(some); count > 0 && read.size() <= MAX_BYTES; count = in.read(some)) {
      read.write(some, 0, count);
    }
    return read.toByteArray();
  }

  /**
   * Converts bytes to samples; of more than two channels the first two, front left and right, are
   * kept.
   */
  private static short[] samples(byte[] bytes, int frames, int channels, int kept) {
    ByteBuffer from = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    short[] samples = new short[frames * kept];
    for (int i = 0; i < samples.length; i++) {
      samples[i] = from.getShort(2 * (i / kept * channels + i % kept));
    }
    return samples;
  }
}
