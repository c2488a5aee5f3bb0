package org.selectiverenderer.browser.loading;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.movie.mpeg.SoundtrackReader;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.browser.sound.SoundFileReader;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Loads the recordings of AudioClips and the soundtracks of movies, for one load. A file that
 * several nodes name is read once, and all recordings together take no more than an eighth of the
 * heap. Thread-safe.
 */
final class SoundLoader {
  private static final String CONSEQUENCE = "the AudioClip is not heard";

  private static final String SILENT = "the Sound stays silent";

  private final UrlResolver root;
  private final Map<String, Decoded> files = new ConcurrentHashMap<>();
  private final AtomicLong budget = new AtomicLong(Runtime.getRuntime().maxMemory() / 8);

  /**
   * @param recording the recording; empty if there is none that can be played
   * @param fault the reason why the file could not be read; empty if it could or is of another
   *     format
   */
  private record Decoded(Optional<AudioBuffer> recording, String fault) {}

  SoundLoader(UrlResolver root) {
    this.root = root;
  }

  /**
   * Loads the recording of an AudioClip; empty, with a message, if it has none that can be played.
   *
   * @param base the base of its relative urls
   */
  Optional<AudioBuffer> read(ParsedNode clip, BaseUrl base, ProblemCollector problems) {
    ResolvedUrlContent choice = ResolvedUrlContent.of(clip, root, base, CONSEQUENCE);
    if (!(choice instanceof ResolvedUrlContent.Found found)) {
      problems.add(((ResolvedUrlContent.None) choice).problem());
      return Optional.empty();
    }
    UrlContent file = found.content();
    Decoded decoded = files.computeIfAbsent(file.key(), key -> decode(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          clip.location(), "%s %s; %s".formatted(file.name(), decoded.fault, CONSEQUENCE));
    } else if (decoded.recording.isEmpty()) {
      problems.info(
          clip.location(),
          "%s is neither WAV, AIFF, AU nor MP3 (`ffmpeg -i FILE FILE.mp3` converts Ogg Vorbis); %s"
              .formatted(file.name(), CONSEQUENCE));
    }
    return decoded.recording;
  }

  /**
   * Loads the soundtrack of a MovieTexture that is the source of a Sound; empty, with a message, if
   * it has none. What is wrong with the file as a movie is told with its pictures.
   *
   * @param base the base of its relative urls
   */
  Optional<AudioBuffer> soundtrack(ParsedNode movie, BaseUrl base, ProblemCollector problems) {
    if (!(ResolvedUrlContent.of(movie, root, base, SILENT)
        instanceof ResolvedUrlContent.Found found)) {
      return Optional.empty();
    }
    UrlContent file = found.content();
    Decoded decoded =
        files.computeIfAbsent("soundtrack of " + file.key(), key -> decodeSoundtrack(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          movie.location(),
          "the soundtrack of %s %s; %s".formatted(file.name(), decoded.fault, SILENT));
    } else if (decoded.recording.isEmpty()) {
      problems.info(
          movie.location(), "%s has no sound of MPEG audio; %s".formatted(file.name(), SILENT));
    }
    return decoded.recording;
  }

  private Decoded decodeSoundtrack(UrlContent file) {
    try {
      return new Decoded(soundtrackOf(file), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), IoErrorFormatter.clause(e));
    }
  }

  private Optional<AudioBuffer> soundtrackOf(UrlContent file) throws IOException {
    Optional<byte[]> audio;
    try (InputStream in = new BufferedInputStream(file.open())) {
      audio = SoundtrackReader.read(in, SoundFileReader.MAX_BYTES);
    }
    return audio.isPresent()
        ? Optional.of(SoundFileReader.mpegAudio(audio.get(), budget))
        : Optional.empty();
  }

  private Decoded decode(UrlContent file) {
    try {
      return new Decoded(SoundFileReader.read(file, budget), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), IoErrorFormatter.clause(e));
    }
  }
}
