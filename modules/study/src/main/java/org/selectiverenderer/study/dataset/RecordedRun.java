package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogReader;

/**
 * A run (BIDS): one presentation of a scene, practice or exposure, to its end or its interruption.
 *
 * @param number of the run among those of this step in this session, from 1
 * @param headName name of the head log's file, without the extension
 * @param finished whether the scene was shown to the end of the step
 * @param events of this run in order, from its begin to its end
 */
public record RecordedRun(
    RecordedSession session,
    String step,
    int number,
    String headName,
    boolean finished,
    List<JournalEvent> events) {
  public RecordedRun {
    events = List.copyOf(events);
  }

  /** Returns the head log's CSV file. */
  public Path headLog() {
    return session.folder().path().resolve("head").resolve(headName + ".csv");
  }

  /**
   * Reads the head log.
   *
   * @return empty if the file does not exist or has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public Optional<HeadLog> head(ProblemCollector problems) throws IOException {
    return Files.isRegularFile(headLog())
        ? HeadLogReader.read(headLog(), problems)
        : Optional.empty();
  }

  /**
   * Returns when the picture had faded in completely, in seconds of the run: the exposure's onset.
   */
  public Optional<Double> shown() {
    return events.stream()
        .filter(line -> line.event().equals("shown"))
        .map(line -> line.members().path("t").asDouble())
        .findFirst();
  }

  /** Returns for how long the experimenter had the run paused, in seconds of wall-clock time. */
  public double paused() {
    double seconds = 0;
    @Nullable OffsetDateTime since = null;
    for (JournalEvent line : events) {
      if (line.event().equals("paused") && since == null) {
        since = line.time();
      } else if (line.event().equals("continued") && since != null) {
        seconds += seconds(since, line.time());
        since = null;
      }
    }
    return seconds;
  }

  /**
   * Returns the wall-clock time at the beginning of the run; empty if nothing was logged.
   *
   * @param log the head log of this run
   */
  public Optional<OffsetDateTime> started(Optional<HeadLog> log) {
    for (JournalEvent line : events) {
      double t =
          switch (line.event()) {
            case "shown" -> line.members().path("t").asDouble();
            case "scene" -> line.members().path("what").path("t").asDouble();
            default -> Double.NaN;
          };
      if (!Double.isNaN(t)) {
        return Optional.of(line.time().minusNanos(Math.round(t * 1e9)));
      }
    }
    return log.flatMap(read -> time(read.description().started()));
  }

  private static Optional<OffsetDateTime> time(String text) {
    try {
      return Optional.of(OffsetDateTime.parse(text));
    } catch (DateTimeException e) {
      return Optional.empty();
    }
  }

  static double seconds(OffsetDateTime from, OffsetDateTime to) {
    return Duration.between(from, to).toNanos() * 1e-9;
  }
}
