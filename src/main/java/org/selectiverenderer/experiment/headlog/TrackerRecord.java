package org.selectiverenderer.experiment.headlog;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
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
 * @param place of the head, where the tracker tells it
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
   * Where the head is, in metres of the tracker's own room.
   *
   * @param right of where the device counts from
   * @param up of there
   * @param back of there, away from the screen
   */
  public record Place(double right, double up, double back) {
    static final List<String> HEADERS = List.of("right", "up", "back");
    private static final int DECIMALS = 5;

    private List<String> cells() {
      return Stream.of(right, up, back).map(way -> DecimalText.fixed(way, DECIMALS)).toList();
    }
  }

  /**
   * The names of the columns.
   *
   * @param placed whether the tracker tells places
   */
  static List<String> headers(boolean placed) {
    return placed ? Stream.of(TURNED, Place.HEADERS).flatMap(List::stream).toList() : TURNED;
  }

  /**
   * The cells, in the order of the headers.
   *
   * @param begun when the log began, by the monotonic clock
   * @param placed whether the tracker tells places; a record without one has empty cells
   */
  List<String> cells(double begun, boolean placed) {
    List<String> turned =
        List.of(
            DecimalText.fixed(mono - begun, 6),
            DecimalText.fixed(yaw, 4),
            DecimalText.fixed(pitch, 4),
            DecimalText.fixed(roll, 4),
            Long.toString(number),
            Column.wall(wall),
            DecimalText.fixed(mono, 6));
    return placed
        ? Stream.of(turned, place.map(Place::cells).orElse(List.of("", "", "")))
            .flatMap(List::stream)
            .toList()
        : turned;
  }
}
