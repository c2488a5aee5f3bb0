package org.selectiverenderer.tracker;

/**
 * Statistics of a tracker's records, of all since it was opened unless stated otherwise.
 *
 * @param records number of good records
 * @param rateHz good records per second over the last 64 of them; 0 before the second
 * @param jitterMs standard deviation of the times between the last 64 records, in milliseconds
 * @param bad number of records that were rejected: wrong checksum, malformed, not a number, out of
 *     range
 * @param dropped number of records that were sent but did not arrive, estimated from gaps in their
 *     times; gaps in which the connection was lost do not count
 * @param silentSeconds seconds since the last good record, or since opening
 * @param reconnects number of times that the connection was lost and restored
 */
public record TrackerHealth(
    State state,
    long records,
    double rateHz,
    double jitterMs,
    long bad,
    long dropped,
    double silentSeconds,
    long reconnects) {
  /** Seconds without a good record after which a tracker counts as silent. */
  public static final double SILENCE = 0.5;

  /** The state of a tracker. */
  public enum State {
    /** No tracker is used. */
    NONE,
    /** Opened; no good record has arrived yet. */
    CONNECTING,
    /** Records arrive. */
    STREAMING,
    /** Connected, but no good record for {@link #SILENCE} seconds: the pose is stale. */
    SILENT,
    /** The connection is lost, and the tracker tries to reconnect. */
    LOST,
    /** A recording has been played to its end. */
    ENDED,
    /** {@link HeadTracker#close} was called. */
    CLOSED
  }

  /** Returns whether the pose is stale. */
  public boolean stale() {
    return state == State.SILENT || state == State.LOST;
  }
}
