package org.selectiverenderer.study.headlog;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.DecimalFormatter;

/**
 * A record of the head tracker as it arrived.
 *
 * @param number of the record since the tracker was opened, from 1; a missing number is a record
 *     that was dropped because the disk was too slow
 * @param mono seconds of the monotonic clock when the record's last byte was read, as in the head
 *     log
 * @param wall date and time at that moment
 * @param yaw degrees as in the head log, but before the boresight (reset of the heading)
 * @param pitch degrees
 * @param roll degrees
 * @param place position of the head, if the tracker measures it
 */
public record TrackerRecord(
    long number,
    double mono,
    Instant wall,
    double yaw,
    double pitch,
    double roll,
    Optional<Place> place) {
  private static final List<String> TURNED =
      List.of("t", "yaw", "pitch", "roll", "number", "wall", "mono");

  /**
   * The position of the head in the tracker's frame, in metres.
   *
   * @param right distance to the right of the tracker's origin
   * @param up distance above the origin
   * @param back distance behind the origin, away from the screen
   */
  public record Place(double right, double up, double back) {
    static final List<String> HEADERS = List.of("right", "up", "back");
    private static final int DECIMALS = 5;

    private List<String> cells() {
      return Stream.of(right, up, back).map(way -> DecimalFormatter.fixed(way, DECIMALS)).toList();
    }
  }

  /**
   * Returns the names of the columns.
   *
   * @param placed whether the tracker measures positions
   */
  static List<String> headers(boolean placed) {
    return placed ? Stream.of(TURNED, Place.HEADERS).flatMap(List::stream).toList() : TURNED;
  }

  /**
   * Returns the cells, in the order of the headers.
   *
   * @param begun begin of the log, in seconds of the monotonic clock
   * @param placed whether the log has the columns of the position; a record without one has empty
   *     cells
   */
  List<String> cells(double begun, boolean placed) {
    List<String> turned =
        List.of(
            DecimalFormatter.fixed(mono - begun, 6),
            DecimalFormatter.fixed(yaw, 4),
            DecimalFormatter.fixed(pitch, 4),
            DecimalFormatter.fixed(roll, 4),
            Long.toString(number),
            HeadLogColumn.wall(wall),
            DecimalFormatter.fixed(mono, 6));
    return placed
        ? Stream.of(turned, place.map(Place::cells).orElse(List.of("", "", "")))
            .flatMap(List::stream)
            .toList()
        : turned;
  }
}
