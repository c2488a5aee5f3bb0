package org.selectiverenderer.experiment.headlog;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalText;

/**
 * The columns of a head log's CSV, in their order. Numbers have a fixed number of decimals: a
 * millionth of a scene unit and of a degree is far below what a tracker tells or a display shows,
 * so that a replay shows the same frames.
 */
enum Column {
  T("seconds since the session began", "s", 6, HeadSample::t),
  X("position of the head, right of the origin", "scene unit", 6, HeadSample::x),
  Y("position of the head, up", "scene unit", 6, HeadSample::y),
  Z("position of the head, towards the viewer of the plan", "scene unit", 6, HeadSample::z),
  YAW("heading about Y, positive to the left", "degrees", 6, HeadSample::yaw),
  PITCH("about X, positive up", "degrees", 6, HeadSample::pitch),
  ROLL("about Z, positive to the left shoulder", "degrees", 6, HeadSample::roll),
  MOTION(
      "moved, or idle: turned by less than 0.05 degrees and moved by less than a thousandth unit"
          + " since the frame before",
      s -> s.moved() ? "moved" : "idle"),
  OBJECT(
      "in the middle of the view, by the DEF of its Switch, else of its outermost Inline, else of"
          + " its outermost group below the room, else the room's; empty for none",
      HeadSample::object),
  DISTANCE(
      "of the object's surface along the line of sight; empty for none",
      "scene unit",
      3,
      HeadSample::distance),
  VERSION(
      "the choice that the object's Switch shows; empty where it has none",
      s -> s.version() < 0 ? "" : Integer.toString(s.version())),
  CONE(
      "objects in the cone about the middle, separated by spaces, the one that fills most first",
      s -> String.join(" ", s.cone())),
  SCHEMAS("active schemas, separated by spaces", s -> String.join(" ", s.schemas())),
  FRAME_MS(
      "from the step of the frame before to that of this one, pauses not counted",
      "ms",
      3,
      HeadSample::frameMs),
  VISIBLE(
      "1 when the participant saw it; 0 while the picture is black or less than half as bright as"
          + " it is, and in a window that is not drawn",
      s -> s.visible() ? "1" : "0"),
  WALL("date and time of the computer, UTC", s -> wall(s.moment().wall())),
  MONO(
      "the computer's monotonic clock, which goes on while a session is paused and t stands still",
      "s",
      6,
      s -> s.moment().mono());

  /** Those that a log has had from the beginning; older logs lack the others. */
  static final List<Column> OLDEST =
      Arrays.stream(values()).filter(column -> column.ordinal() <= FRAME_MS.ordinal()).toList();

  private static final DateTimeFormatter WALL_CLOCK =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  /** What stands in the description of a log. */
  final String meaning;

  /** Empty for columns that are no numbers. */
  final String units;

  /** How many a number has; -1 for columns that are no numbers. */
  final int decimals;

  private final String header = name().toLowerCase(Locale.ROOT);
  private final Function<HeadSample, String> value;

  Column(String meaning, String units, int decimals, ToDoubleFunction<HeadSample> number) {
    this.meaning = meaning;
    this.units = units;
    this.decimals = decimals;
    value = sample -> text(number.applyAsDouble(sample), decimals);
  }

  Column(String meaning, Function<HeadSample, String> value) {
    this.meaning = meaning;
    this.value = value;
    units = "";
    decimals = -1;
  }

  /** A date and time as it stands in a log; empty for none. */
  static String wall(@Nullable Instant time) {
    return time == null ? "" : WALL_CLOCK.format(time);
  }

  private static String text(double number, int decimals) {
    return Double.isFinite(number) ? DecimalText.fixed(number, decimals) : "";
  }

  /** As the header of the CSV names it. */
  String header() {
    return header;
  }

  /** The names of all, in their order. */
  static List<String> headers() {
    return Arrays.stream(values()).map(Column::header).toList();
  }

  /** A sample's cells, in the order of the columns. */
  static List<String> cells(HeadSample sample) {
    return Arrays.stream(values()).map(column -> column.value.apply(sample)).toList();
  }
}
