package org.selectiverenderer.tracker.report;

import org.selectiverenderer.tracker.LatencyHistogram;
import org.selectiverenderer.tracker.TrackerHealth;

/**
 * Statistics of a whole recording.
 *
 * @param records number of good records
 * @param rateHz mean rate from the first to the last record, pauses included; 0 for fewer than two
 * @param jitterMs standard deviation of the times between records, in milliseconds
 * @param bad number of rejected records
 * @param dropped number of records that did not arrive ({@link TrackerHealth}) or could not be
 *     written in time
 * @param ageMedianMs median age of a new record when a display of {@link TrackSession#FRAME_RATE}
 *     frames per second draws it, in milliseconds
 * @param ageP99Ms 99th percentile of that age
 */
record TrackStatistics(
    long records,
    double rateHz,
    double jitterMs,
    long bad,
    long dropped,
    double ageMedianMs,
    double ageP99Ms) {

  /** Accumulates mean and variance of the intervals between records (Welford 1962). */
  static final class Intervals {
    private long records;
    private long first;
    private long last;
    private double mean;
    private double squares;

    void add(long arrival) {
      records++;
      if (records == 1) {
        first = arrival;
      } else {
        double interval = (arrival - last) * 1e-6;
        double off = interval - mean;
        mean += off / (records - 1);
        squares += off * (interval - mean);
      }
      last = arrival;
    }

    TrackStatistics figures(TrackerHealth health, long lost, LatencyHistogram age) {
      double span = (last - first) * 1e-9;
      return new TrackStatistics(
          records + lost,
          span > 0 ? (records + lost - 1) / span : 0,
          records > 2 ? Math.sqrt(squares / (records - 2)) : 0,
          health.bad(),
          health.dropped() + lost,
          age.percentileMs(0.5),
          age.percentileMs(0.99));
    }
  }
}
