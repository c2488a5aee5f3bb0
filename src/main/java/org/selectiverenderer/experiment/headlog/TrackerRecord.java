package org.selectiverenderer.experiment.headlog;

import java.time.Instant;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalText;

/**
 * A record of the head tracker, as it arrived, at the tracker's own rate.
 *
 * @param number of the record since the tracker was opened, from 1; a number left out is a record
 *     that the disk was too slow for
 * @param mono seconds of the computer's monotonic clock when its last byte was read, as in the head
 *     log
 * @param wall date and time of the computer then
 * @param yaw degrees, before the heading is reset, otherwise as in the head log
 * @param pitch degrees
 * @param roll degrees
 */
public record TrackerRecord(
    long number, double mono, Instant wall, double yaw, double pitch, double roll) {
  static final List<String> HEADERS =
      List.of("t", "yaw", "pitch", "roll", "number", "wall", "mono");

  /**
   * The cells, in the order of the headers.
   *
   * @param begun when the log began, by the monotonic clock
   */
  List<String> cells(double begun) {
    return List.of(
        DecimalText.fixed(mono - begun, 6),
        DecimalText.fixed(yaw, 4),
        DecimalText.fixed(pitch, 4),
        DecimalText.fixed(roll, 4),
        Long.toString(number),
        Column.wall(wall),
        DecimalText.fixed(mono, 6));
  }
}
