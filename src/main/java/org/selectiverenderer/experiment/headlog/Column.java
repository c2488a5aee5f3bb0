package org.selectiverenderer.experiment.headlog;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** The columns of a head log's CSV, in their order. */
enum Column {
  T("seconds since the session began", "s", s -> text(s.t())),
  X("position of the head, right of the origin", "scene unit", s -> text(s.x())),
  Y("position of the head, up", "scene unit", s -> text(s.y())),
  Z("position of the head, towards the viewer of the plan", "scene unit", s -> text(s.z())),
  YAW("heading about Y, positive to the left", "degrees", s -> text(s.yaw())),
  PITCH("about X, positive up", "degrees", s -> text(s.pitch())),
  ROLL("about Z, positive to the left shoulder", "degrees", s -> text(s.roll())),
  MOTION(
      "moved, or idle: turned by less than 0.05 degrees and moved by less than a thousandth unit"
          + " since the frame before",
      "",
      s -> s.moved() ? "moved" : "idle"),
  OBJECT(
      "in the middle of the view, by the DEF of its Switch, of its Inline or the nearest DEF; empty for none",
      "",
      HeadSample::object),
  DISTANCE(
      "of the object's surface along the line of sight",
      "scene unit",
      s -> Double.isNaN(s.distance()) ? "" : rounded(s.distance())),
  VERSION(
      "the choice that the object's Switch shows; empty where it has none",
      "",
      s -> s.version() < 0 ? "" : Integer.toString(s.version())),
  CONE(
      "objects in the cone about the middle, separated by spaces, the one that fills most first",
      "",
      s -> String.join(" ", s.cone())),
  SCHEMAS("active schemas, separated by spaces", "", s -> String.join(" ", s.schemas())),
  FRAME_MS("from the frame before to this one", "ms", s -> rounded(s.frameMs()));

  /** What stands in the description of a log. */
  final String meaning;

  /** Empty for columns that are no numbers. */
  final String units;

  private final Function<HeadSample, String> value;

  Column(String meaning, String units, Function<HeadSample, String> value) {
    this.meaning = meaning;
    this.units = units;
    this.value = value;
  }

  /** As the header of the CSV names it. */
  String header() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The first line of the CSV. */
  static String headers() {
    return String.join(",", List.of(values()).stream().map(Column::header).toList());
  }

  /**
   * A line of the CSV, without its end. Poses have all their digits, so that a replay shows the
   * same frames.
   */
  static String line(HeadSample sample) {
    StringBuilder line = new StringBuilder(160);
    for (Column column : values()) {
      if (column != T) {
        line.append(',');
      }
      line.append(quoted(column.value.apply(sample)));
    }
    return line.toString();
  }

  private static String quoted(String cell) {
    boolean plain = cell.indexOf(',') < 0 && cell.indexOf('"') < 0;
    return plain ? cell : '"' + cell.replace("\"", "\"\"") + '"';
  }

  private static String text(double value) {
    return Double.toString(value);
  }

  /** To a thousandth, always with a point whatever the locale. */
  private static String rounded(double value) {
    return Double.toString(Math.round(value * 1000) / 1000.0);
  }
}
