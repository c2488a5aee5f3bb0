package org.selectiverenderer.tracker.pipeline;

import org.selectiverenderer.tracker.TrackerHealth;

/**
 * Computes statistics of the records. The tracker's thread adds records without allocating; any
 * thread reads.
 */
final class TrackerHealthMonitor {
  private static final int WINDOW = 64;

  /** Number of records after which the usual interval counts as known. */
  private static final int ENOUGH = 16;

  private final long[] arrivals = new long[WINDOW];
  private final DroppedRecordEstimator gaps = new DroppedRecordEstimator();
  private long lastGood = System.nanoTime();
  private long records;
  private int inWindow;
  private long bad;
  private long badSinceGood;
  private long reconnects;

  synchronized void good(long arrival) {
    if (inWindow > 0) {
      double usual = inWindow < ENOUGH ? 0 : span() / (Math.min(inWindow, WINDOW) - 1);
      gaps.interval((arrival - lastGood) * 1e-9, usual, badSinceGood);
    }
    badSinceGood = 0;
    lastGood = arrival;
    arrivals[inWindow++ % WINDOW] = arrival;
    if (inWindow == 2 * WINDOW) {
      inWindow = WINDOW; // The window stays full, at the same place in the ring.
    }
    records++;
  }

  synchronized void bad() {
    bad++;
    badSinceGood++;
  }

  /** Restarts the timing statistics after a pause, so that it does not count as an interval. */
  synchronized void pause() {
    inWindow = 0;
    badSinceGood = 0;
    gaps.restart();
  }

  synchronized void reconnected() {
    reconnects++;
  }

  /** Returns the seconds since the last good record. */
  synchronized double silence(long now) {
    return Math.max(0, (now - lastGood) * 1e-9);
  }

  /** Returns the number of bad records since the last good one. */
  synchronized long badSinceGood() {
    return badSinceGood;
  }

  synchronized long records() {
    return records;
  }

  synchronized TrackerHealth health(TrackerHealth.State state, long now) {
    int count = Math.min(inWindow, WINDOW);
    double mean = count < 2 ? 0 : span() / (count - 1);
    return new TrackerHealth(
        state,
        records,
        mean > 0 ? 1 / mean : 0,
        mean > 0 ? deviation(count, mean) * 1e3 : 0,
        bad,
        gaps.dropped(),
        silence(now),
        reconnects);
  }

  /** Returns the time from the first to the last record of the window, in seconds. */
  private double span() {
    int count = Math.min(inWindow, WINDOW);
    return (arrival(inWindow - 1) - arrival(inWindow - count)) * 1e-9;
  }

  private double deviation(int count, double mean) {
    double sum = 0;
    for (int i = inWindow - count + 1; i < inWindow; i++) {
      double off = (arrival(i) - arrival(i - 1)) * 1e-9 - mean;
      sum += off * off;
    }
    return Math.sqrt(sum / (count - 1));
  }

  private long arrival(int index) {
    return arrivals[index % WINDOW];
  }

  /**
   * Estimates how many records were dropped, from the times of those that arrived: none of the
   * protocols numbers its records. A gap much longer than the usual interval lacks the records that
   * would have filled it, unless a burst of records follows at once: those were late, not lost (a
   * USB adapter or a pause of this program delayed them).
   */
  private static final class DroppedRecordEstimator {
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
}
