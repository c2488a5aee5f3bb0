package org.selectiverenderer.app.stream;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.base.files.FileWriteException;
import org.selectiverenderer.lsl.LslInlet;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.LslResolver;
import org.selectiverenderer.lsl.StreamInfo;

/**
 * Records LSL streams of other programs, as soon as they appear, on its own thread {@code lsl-in}.
 * A full disk ends the recording of a stream with a message, but not the session.
 */
final class StreamRecorder implements AutoCloseable {
  private static final long PAUSE = 10_000_000;
  private static final double SEARCH_EVERY = 0.5;
  private static final double KEEP_EVERY = 0.6;
  private static final double COMPARE_EVERY = 5;

  /**
   * The seconds to wait for a clock offset; {@code LAST_OFFSET_TIMEOUT} applies at the end to an
   * offset that is still unknown.
   */
  private static final double OFFSET_TIMEOUT = 0.1;

  private static final double LAST_OFFSET_TIMEOUT = 4;

  /** The seconds after which a requested stream that has not appeared is reported. */
  private static final double PATIENCE = 10;

  private static final double NAMES_TIMEOUT = 2;

  /** Receives the events of the recorder, on its thread. */
  interface Listener {
    /** Reports that the recording of a stream has started. */
    void began(StreamInfo stream, Path file);

    /** Reports that the recording of a stream has ended. */
    void ended(StreamInfo stream, Path file, long samples);

    /**
     * Reports that a stream of texts tells of a calibration.
     *
     * @param time seconds of the sender's clock
     */
    void calibrated(StreamInfo stream, double time, String text);

    /** Reports a problem. */
    void problem(String text);
  }

  private final LslLibrary lsl;
  private final Map<String, LslResolver> resolvers;
  private final Path folder;
  private final Set<String> own;
  private final Listener listener;
  private final Set<String> known = new HashSet<>();
  private final Set<String> found = new HashSet<>();
  private final List<StreamRecording> streams = new ArrayList<>();
  private final Thread thread = new Thread(this::work, "lsl-in");
  private volatile boolean closing;

  private StreamRecorder(
      LslLibrary lsl,
      Map<String, LslResolver> resolvers,
      Path folder,
      Set<String> own,
      Listener listener) {
    this.lsl = lsl;
    this.resolvers = resolvers;
    this.folder = folder;
    this.own = own;
    this.listener = listener;
  }

  /**
   * Starts looking for streams.
   *
   * @param predicates LSL predicates; a stream that matches several is recorded once
   * @param folder output folder, created when needed
   * @param own source ids of this program's own streams, which are not recorded
   * @throws IOException if a predicate is malformed
   */
  static StreamRecorder open(
      LslLibrary lsl, List<String> predicates, Path folder, Set<String> own, Listener listener)
      throws IOException {
    Map<String, LslResolver> resolvers = new LinkedHashMap<>();
    try {
      for (String predicate : predicates) {
        if (!resolvers.containsKey(predicate)) {
          resolvers.put(predicate, lsl.resolver(predicate));
        }
      }
    } catch (IOException e) {
      resolvers.values().forEach(LslResolver::close);
      throw e;
    }
    StreamRecorder recorder = new StreamRecorder(lsl, resolvers, folder, own, listener);
    recorder.thread.start();
    return recorder;
  }

  private void work() {
    double began = lsl.clock();
    double searched = Double.NEGATIVE_INFINITY;
    double compared = began;
    double kept = began;
    boolean told = false;
    while (!closing) {
      double now = lsl.clock();
      if (now - searched >= SEARCH_EVERY) {
        searched = now;
        search();
      }
      if (!told && now - began >= PATIENCE) {
        told = true;
        tellMissing();
      }
      boolean compare = now - compared >= COMPARE_EVERY;
      boolean keep = now - kept >= KEEP_EVERY;
      compared = compare ? now : compared;
      kept = keep ? now : kept;
      if (!round(compare, keep)) {
        LockSupport.parkNanos(PAUSE);
      }
    }
    while (round(false, false)) {
      // Until all samples that have arrived are written.
    }
    round(true, true);
    List.copyOf(streams).forEach(this::end);
    resolvers.values().forEach(LslResolver::close);
  }

  private void search() {
    resolvers.forEach(
        (predicate, resolver) -> {
          for (LslInlet inlet : resolver.found(known)) {
            found.add(predicate);
            begin(inlet);
          }
        });
  }

  private void begin(LslInlet inlet) {
    StreamInfo stream = inlet.description(NAMES_TIMEOUT);
    known.add(stream.uid());
    if (own.contains(stream.sourceId()) || recovered(stream)) {
      inlet.close();
      return;
    }
    try {
      StreamRecording recorded = StreamRecording.open(inlet, stream, folder);
      streams.add(recorded);
      recorded.compare(lsl, 0);
      listener.began(stream, recorded.file());
    } catch (IOException e) {
      listener.problem(
          "the stream %s is not recorded: %s"
              .formatted(stream.name(), FileWriteException.named(folder, e).getMessage()));
    }
  }

  /**
   * Returns whether a stream continues one that is being recorded: the LSL library reconnects the
   * stream of a program that was restarted.
   */
  private boolean recovered(StreamInfo stream) {
    return !stream.sourceId().isEmpty()
        && streams.stream()
            .map(StreamRecording::stream)
            .anyMatch(
                there ->
                    there.sourceId().equals(stream.sourceId())
                        && there.name().equals(stream.name())
                        && there.type().equals(stream.type()));
  }

  private void tellMissing() {
    for (String predicate : resolvers.keySet()) {
      if (!found.contains(predicate)) {
        listener.problem(
            "no LSL stream matches %s yet; it is recorded as soon as it appears"
                .formatted(predicate));
      }
    }
  }

  /** Writes pending samples of all streams and returns whether there may be more. */
  private boolean round(boolean compare, boolean keep) {
    boolean more = false;
    for (StreamRecording stream : List.copyOf(streams)) {
      try {
        more |= stream.take((time, text) -> listener.calibrated(stream.stream(), time, text));
        if (compare || keep && !stream.known()) {
          stream.compare(lsl, closing && !stream.known() ? LAST_OFFSET_TIMEOUT : OFFSET_TIMEOUT);
        }
        if (keep) {
          stream.keep();
        }
      } catch (IOException e) {
        listener.problem(
            "the recording of the stream %s ends here: %s"
                .formatted(
                    stream.stream().name(),
                    FileWriteException.named(stream.file(), e).getMessage()));
        end(stream);
      }
    }
    return more;
  }

  private void end(StreamRecording stream) {
    streams.remove(stream);
    try {
      stream.close();
    } catch (IOException e) {
      listener.problem(FileWriteException.named(stream.file(), e).getMessage());
    }
    listener.ended(stream.stream(), stream.file(), stream.count());
  }

  /** Writes pending samples and ends all recordings. */
  @Override
  public void close() {
    closing = true;
    LockSupport.unpark(thread);
    ThreadJoiner.join(thread);
  }
}
