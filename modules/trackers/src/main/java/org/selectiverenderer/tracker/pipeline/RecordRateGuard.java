package org.selectiverenderer.tracker.pipeline;

/** Detects a flood: far more records per second than any head tracker sends. */
final class RecordRateGuard {
  /** Limit in records per second; the fastest head trackers send a thousand. */
  static final int LIMIT = 5_000;

  private long begin;
  private int count;
  private boolean flooded;

  /**
   * Counts a record.
   *
   * @return true once at the beginning of each flood
   */
  boolean record(long arrival) {
    if (count++ == 0) {
      begin = arrival;
    }
    if (arrival - begin < 1_000_000_000L) {
      if (count <= LIMIT || flooded) {
        return false;
      }
      flooded = true;
      return true;
    }
    flooded &= count > LIMIT;
    begin = arrival;
    count = 1;
    return false;
  }
}
