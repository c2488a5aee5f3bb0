package org.selectiverenderer.study.headlog;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;

/**
 * The columns of a head log's CSV, in their order. Numbers have a fixed number of decimals: a
 * millionth of a scene unit and of a degree is far below the resolution of trackers and displays,
 * so that a replay shows the same frames.
 */
enum HeadLogColumn {
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
      s -> s.moment().mono()),
  EYES(
      "tracked, or lost while the eye tracker does not see the eyes, as in a blink",
      eyes(e -> e.tracked() ? "tracked" : "lost")),
  GAZE_YAW(
      "where the eyes look, from straight ahead of the head, positive to the left; empty while lost",
      "degrees",
      6,
      eyesNumber(EyeSample::yaw)),
  GAZE_PITCH(
      "where the eyes look, above straight ahead of the head; empty while lost",
      "degrees",
      6,
      eyesNumber(EyeSample::pitch)),
  GAZE_OBJECT("what the eyes look at, named as in object; empty for none", eyes(EyeSample::object)),
  GAZE_DISTANCE(
      "of the surface that the eyes look at; empty for none",
      "scene unit",
      3,
      eyesNumber(EyeSample::distance)),
  GAZE_VERSION(
      "the choice that the Switch of what the eyes look at shows; empty where it has none",
      eyes(e -> e.version() < 0 ? "" : Integer.toString(e.version())));

  /** Columns of the oldest format; logs of that format lack the others. */
  static final List<HeadLogColumn> OLDEST =
      Arrays.stream(values()).filter(column -> column.ordinal() <= FRAME_MS.ordinal()).toList();

  /** Columns of gaze data, which only a log of a headset with an eye tracker has. */
  private static final List<HeadLogColumn> OF_EYES =
      List.of(EYES, GAZE_YAW, GAZE_PITCH, GAZE_OBJECT, GAZE_DISTANCE, GAZE_VERSION);

  private static final DateTimeFormatter WALL_CLOCK =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  /** Meaning of the column, as the log's description states it. */
  final String meaning;

  /** Unit of the numbers; empty for a column of texts. */
  final String units;

  /** Decimals of the numbers; -1 for a column of texts. */
  final int decimals;

  private final String header = name().toLowerCase(Locale.ROOT);
  private final Function<HeadSample, String> value;

  HeadLogColumn(String meaning, String units, int decimals, ToDoubleFunction<HeadSample> number) {
    this.meaning = meaning;
    this.units = units;
    this.decimals = decimals;
    value = sample -> text(number.applyAsDouble(sample), decimals);
  }

  HeadLogColumn(String meaning, Function<HeadSample, String> value) {
    this.meaning = meaning;
    this.value = value;
    units = "";
    decimals = -1;
  }

  private static Function<HeadSample, String> eyes(Function<EyeSample, String> text) {
    return sample -> {
      EyeSample eyes = sample.eyes();
      return eyes == null ? "" : text.apply(eyes);
    };
  }

  private static ToDoubleFunction<HeadSample> eyesNumber(ToDoubleFunction<EyeSample> number) {
    return sample -> {
      EyeSample eyes = sample.eyes();
      return eyes == null ? Double.NaN : number.applyAsDouble(eyes);
    };
  }

  /** Returns date and time as a log writes them; empty for null. */
  static String wall(@Nullable Instant time) {
    return time == null ? "" : WALL_CLOCK.format(time);
  }

  private static String text(double number, int decimals) {
    return Double.isFinite(number) ? DecimalFormatter.fixed(number, decimals) : "";
  }

  /** Returns the column's name in the header of the CSV. */
  String header() {
    return header;
  }

  /**
   * Returns the columns of a log, in their order.
   *
   * @param eyes whether the log has gaze data
   */
  static List<HeadLogColumn> of(boolean eyes) {
    return Arrays.stream(values()).filter(column -> eyes || !OF_EYES.contains(column)).toList();
  }

  /** Returns the cell of a sample. */
  String cell(HeadSample sample) {
    return value.apply(sample);
  }
}
