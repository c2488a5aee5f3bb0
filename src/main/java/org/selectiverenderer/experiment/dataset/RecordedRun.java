package org.selectiverenderer.experiment.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.headlog.HeadLog;
import org.selectiverenderer.experiment.headlog.HeadLogReader;

/**
 * A scene shown once: practice or an exposure, from its beginning to its end or to what cut it off.
 *
 * @param number of the run of this step in this session, from 1
 * @param headName of the head log, without ending
 * @param finished whether it was shown to its end
 * @param events of this run, in order, its begin and its end among them
 */
public record RecordedRun(
    RecordedSession session,
    String step,
    int number,
    String headName,
    boolean finished,
    List<JournalLine> events) {
  public RecordedRun {
    events = List.copyOf(events);
  }

  /** The head log's CSV. */
  public Path headLog() {
    return session.folder().path().resolve("head").resolve(headName + ".csv");
  }

  /**
   * Reads the head log.
   *
   * @return empty when it is not there or has faults, which are then in {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public Optional<HeadLog> head(Problems problems) throws IOException {
    return Files.isRegularFile(headLog())
        ? HeadLogReader.read(headLog(), problems)
        : Optional.empty();
  }

  /** When the exposure began: the picture was complete; in seconds of the run. */
  public Optional<Double> shown() {
    return events.stream()
        .filter(line -> line.event().equals("shown"))
        .map(line -> line.members().path("t").asDouble())
        .findFirst();
  }

  /** Seconds of the clock on the wall that the experimenter had it paused. */
  public double paused() {
    double seconds = 0;
    @Nullable OffsetDateTime since = null;
    for (JournalLine line : events) {
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
   * The clock on the wall at the beginning of the run; empty where nothing was logged.
   *
   * @param log of this run
   */
  public Optional<OffsetDateTime> started(Optional<HeadLog> log) {
    for (JournalLine line : events) {
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
