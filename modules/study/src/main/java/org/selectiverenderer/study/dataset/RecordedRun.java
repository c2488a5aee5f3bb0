package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.SwitchSightings;

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

  /**
   * Returns the head log with the limits of the time in view, as the codebook defines it: from when
   * the picture has faded in completely until it begins to fade out. A run that something cut off
   * is in view to the end of its log; one that was cut off before its picture was complete never
   * was.
   *
   * @param fade seconds of the picture's fade-out
   */
  public HeadLog inView(HeadLog log, double fade) {
    double begin = shown().orElse(finished ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY);
    return log.inView(begin, finished ? end(log) - fade : Double.POSITIVE_INFINITY);
  }

  /** Returns the time of a log's last sample. */
  static double end(HeadLog log) {
    return log.samples().get(log.samples().size() - 1).t();
  }

  /** Returns the changes of versions that the journal tells, and what was seen of them. */
  public SwitchSightings switches() {
    return SwitchSightings.of(
        events.stream()
            .filter(line -> line.event().equals("scene"))
            .map(line -> line.members().path("what"))
            .toList());
  }

  /** Returns for how long the experimenter had the run paused, in seconds. */
  public double paused() {
    double seconds = 0;
    double since = Double.NaN;
    for (JournalEvent line : events) {
      if (line.event().equals("paused") && Double.isNaN(since)) {
        since = line.seconds();
      } else if (line.event().equals("continued") && !Double.isNaN(since)) {
        seconds += line.seconds() - since;
        since = Double.NaN;
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
      double t = runTime(line);
      if (!Double.isNaN(t)) {
        return Optional.of(line.time().minusNanos(Math.round(t * 1e9)));
      }
    }
    return log.flatMap(read -> time(read.description().started()));
  }

  /**
   * Returns the beginning of the run in {@link JournalEvent#seconds}; empty if nothing was logged.
   *
   * @param log the head log of this run
   */
  public OptionalDouble beganAt(Optional<HeadLog> log) {
    for (JournalEvent line : events) {
      double t = runTime(line);
      if (!Double.isNaN(t)) {
        return OptionalDouble.of(line.seconds() - t);
      }
    }
    JournalEvent first = events.get(0);
    return started(log)
        .map(
            wall ->
                OptionalDouble.of(
                    first.seconds() + Duration.between(first.time(), wall).toNanos() * 1e-9))
        .orElseGet(OptionalDouble::empty);
  }

  /** Returns the time of the run that an event has; NaN if it has none. */
  private static double runTime(JournalEvent line) {
    return switch (line.event()) {
      case "shown" -> line.members().path("t").asDouble();
      case "scene" -> line.members().path("what").path("t").asDouble();
      default -> Double.NaN;
    };
  }

  private static Optional<OffsetDateTime> time(String text) {
    try {
      return Optional.of(OffsetDateTime.parse(text));
    } catch (DateTimeException e) {
      return Optional.empty();
    }
  }
}
