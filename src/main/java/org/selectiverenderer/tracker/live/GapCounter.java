package org.selectiverenderer.tracker.live;

/**
 * Estimates how many records were sent but did not come, from the times of those that came: no
 * protocol here numbers its records. A gap much longer than the usual time between two records
 * lacks those that would have filled it; but records that come right after it, in a bunch, were
 * late and not lost (a USB adapter or a pause of this program held them back).
 */
final class GapCounter {
  /** A gap of fewer usual times between records is jitter. */
  private static final double GAP = 1.75;

  /** A record that comes faster than this share of the usual time belongs to a bunch. */
  private static final double BUNCH = 0.75;

  private long late;
  private long dropped;

  /**
   * Takes the time from one good record to the next.
   *
   * @param seconds between the two
   * @param usual time between two records, in seconds; 0 when not known
   * @param bad records that came between the two: they are counted elsewhere
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

  /** Forgets the gap that is open: the connection was lost, or the tracker fell silent. */
  void restart() {
    dropped += late;
    late = 0;
  }

  long dropped() {
    return dropped;
  }
}
