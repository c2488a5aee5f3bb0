package org.selectiverenderer.tracker;

/**
 * How well a tracker's records arrive. Figures are of all records since it was opened unless said
 * otherwise.
 *
 * @param records that arrived and were good
 * @param rateHz good records per second over the last 64 of them; 0 before the second
 * @param jitterMs standard deviation of the times between the last 64 records, in milliseconds
 * @param bad records that were thrown away: wrong checksum, malformed, not a number, out of range
 * @param dropped records that must have been sent but did not come, estimated from gaps in their
 *     times; gaps in which the connection was lost are not counted
 * @param silentSeconds since the last good record, or since opening
 * @param reconnects how often the connection was lost and made again
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
  /** After this long without a good record a tracker counts as silent, in seconds. */
  public static final double SILENCE = 0.5;

  /** What a tracker is doing. */
  public enum State {
    /** There is none, by choice. */
    NONE,
    /** Opened; no good record has come yet. */
    CONNECTING,
    /** Records come. */
    STREAMING,
    /** Connected, but nothing good came for {@link #SILENCE}: the view has no fresh pose. */
    SILENT,
    /** The connection is lost; it is being tried again. */
    LOST,
    /** A recording that has been played to its end. */
    ENDED,
    /** {@link HeadTracker#close} was called. */
    CLOSED
  }

  /** Whether a reader should be told that the pose is old. */
  public boolean stale() {
    return state == State.SILENT || state == State.LOST;
  }
}
