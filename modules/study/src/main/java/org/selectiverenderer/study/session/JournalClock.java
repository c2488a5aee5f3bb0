package org.selectiverenderer.study.session;

import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * The two clocks of a journal: the wall clock, which people and time servers set, and the monotonic
 * clock of the process, from which durations come. Thread-safe.
 */
final class JournalClock {
  /** The greatest difference between the two clocks' steps that is not flagged. */
  static final Duration TOLERANCE = Duration.ofSeconds(2);

  /**
   * A reading of both clocks.
   *
   * @param nanos the monotonic clock in nanoseconds; its origin is arbitrary and holds for one
   *     process
   * @param moved how far the wall clock has moved against the monotonic one since the first reading
   *     or the last reported move; empty within the tolerance
   */
  record Reading(OffsetDateTime wall, long nanos, Optional<Duration> moved) {}

  private final Supplier<OffsetDateTime> wall;
  private final LongSupplier nanos;
  private @Nullable OffsetDateTime firstWall;
  private long firstNanos;

  JournalClock(Supplier<OffsetDateTime> wall, LongSupplier nanos) {
    this.wall = wall;
    this.nanos = nanos;
  }

  /** Returns the clocks of the machine. */
  static JournalClock system() {
    return new JournalClock(OffsetDateTime::now, System::nanoTime);
  }

  /** Reads both clocks. */
  synchronized Reading read() {
    long monotonic = nanos.getAsLong();
    OffsetDateTime now = wall.get();
    OffsetDateTime since = firstWall;
    if (since != null) {
      Duration moved = Duration.between(since, now).minusNanos(monotonic - firstNanos);
      if (moved.abs().compareTo(TOLERANCE) <= 0) {
        return new Reading(now, monotonic, Optional.empty());
      }
      firstWall = now;
      firstNanos = monotonic;
      return new Reading(now, monotonic, Optional.of(moved));
    }
    firstWall = now;
    firstNanos = monotonic;
    return new Reading(now, monotonic, Optional.empty());
  }
}
