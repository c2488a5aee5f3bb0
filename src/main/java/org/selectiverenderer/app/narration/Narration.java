package org.selectiverenderer.app.narration;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.browser.sound.AudioPlayer;
import org.selectiverenderer.browser.sound.SoundFileReader;
import org.selectiverenderer.browser.sound.SoundLine;
import org.selectiverenderer.browser.sound.Voice;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Plays the audio of the page that a participant reads: by itself when the page is shown, and again
 * when the participant asks for it. It stops when another page is shown. Where nothing can be
 * played the session goes on; a missing device and each faulty file are told once.
 *
 * <p>Calls may come from any thread. {@link #show} is called at every frame, or at least every
 * quarter of a second: without it the sound fades away.
 */
public final class Narration implements AutoCloseable {
  /** Bytes that the recordings of a session may take together. */
  private static final long MOST_BYTES = 256L << 20;

  private static final double NANO = 1e-9;
  private static final Voice.Rank FIRST = new Voice.Rank(1, 0, 1);

  private final AudioPlayer player;
  private final LongSupplier clock;
  private final Consumer<String> warning;
  private final AtomicLong budget = new AtomicLong(MOST_BYTES);
  private final Map<Path, Optional<AudioBuffer>> read = new HashMap<>();
  private @Nullable Object page;
  private @Nullable AudioBuffer recording;
  private Object source = new Object();
  private long began;

  /**
   * @param device opens the sound device, with the first audio
   * @param clock monotonic time in nanoseconds
   * @param warning receives a sentence for each fault, for the experimenter
   */
  public Narration(SoundLine.Opening device, LongSupplier clock, Consumer<String> warning) {
    player = new AudioPlayer(device);
    this.clock = clock;
    this.warning = warning;
  }

  /** Reads a file beforehand, as decoding may take longer than a frame. */
  public synchronized void load(Path file) {
    recording(file);
  }

  /**
   * Goes on with the audio of a page; begins it if another page was shown before.
   *
   * @param shown identity of the page
   * @param audio its file; empty for a page without audio
   */
  public synchronized void show(Object shown, Optional<Path> audio) {
    if (!shown.equals(page)) {
      page = shown;
      recording = audio.flatMap(this::recording).orElse(null);
      again();
    }
    play();
  }

  /** Plays the audio of the page from its beginning. */
  public synchronized void again() {
    source = new Object();
    began = clock.getAsLong();
  }

  /** Ends the page: its audio stops. */
  public synchronized void hide() {
    page = null;
    recording = null;
    play();
  }

  /** Returns whether audio is being played. */
  public synchronized boolean playing() {
    return recording != null && seconds() < recording.seconds();
  }

  private double seconds() {
    return (clock.getAsLong() - began) * NANO;
  }

  private void play() {
    AudioBuffer heard = recording;
    player.play(
        heard == null || !playing()
            ? List.of()
            : List.of(new Voice(source, heard, seconds(), 1, false, 1, 1, true, FIRST)));
    player
        .fault()
        .ifPresent(
            reason ->
                warning.accept(
                    "the audio of the study cannot be played: "
                        + reason
                        + "; the session goes on without it"));
  }

  private Optional<AudioBuffer> recording(Path file) {
    return read.computeIfAbsent(
        file,
        first -> {
          Optional<String> fault;
          try {
            Optional<AudioBuffer> found = read(first, budget);
            if (found.isPresent()) {
              return found;
            }
            fault = Optional.of("has a format that cannot be played");
          } catch (IOException e) {
            fault = Optional.ofNullable(e.getMessage());
          }
          warning.accept("the audio " + first + " " + fault.orElse("cannot be read"));
          return Optional.empty();
        });
  }

  /**
   * Reads a sound file.
   *
   * @param budget the bytes left for recordings; reduced by this one
   * @return empty if the file is of another format
   * @throws IOException with a clause as message that follows the file's name
   */
  public static Optional<AudioBuffer> read(Path file, AtomicLong budget) throws IOException {
    return SoundFileReader.read(
        new UrlContent.OfFile(file, String.valueOf(file.getFileName())), budget);
  }

  @Override
  public void close() {
    player.close();
  }
}
