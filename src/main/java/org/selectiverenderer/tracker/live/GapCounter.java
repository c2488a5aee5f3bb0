package org.selectiverenderer.tracker.live;

/**
 * Estimates how many records were dropped, from the times of those that arrived: none of the
 * protocols numbers its records. A gap much longer than the usual interval lacks the records that
 * would have filled it, unless a burst of records follows at once: those were late, not lost (a USB
 * adapter or a pause of this program delayed them).
 */
final class GapCounter {
  /** Gaps up to this multiple of the usual interval are jitter. */
  private static final double GAP = 1.75;

  /** A record after less than this share of the usual interval belongs to a burst. */
  private static final double BUNCH = 0.75;

  private long late;
  private long dropped;

  /**
   * Handles the interval between two consecutive good records.
   *
   * @param seconds the interval
   * @param usual the usual interval in seconds; 0 if unknown
   * @param bad number of bad records between the two, which are counted elsewhere
   */
  void interval(double seconds, double usual, long bad) {
    if (late > 0 && seconds < usual * BUNCH) {
      late--;
      return;
    }
    dropped += late;
    late = 0;
    if (usual > 0 && seconds > GAP * usual) {
      late = Math.max(0, Math.round(seconds / usual) - 1 - bad);
    }
  }

  /** Restarts after a lost connection or a silence, without counting it as a gap. */
  void restart() {
    dropped += late;
    late = 0;
  }

  long dropped() {
    return dropped;
  }
}
