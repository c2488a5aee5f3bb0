package org.selectiverenderer.study.definition;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;

/** Reads {@code "quality"} of a study file. */
final class QualityCriteriaReader {
  /** Upper limit of frames per second; a greater number is a typing error. */
  private static final double MOST_FPS = 1000;

  private static final double LONGEST = 3600;

  private QualityCriteriaReader() {}

  static QualityCriteria read(JsonObjectReader study) {
    return study
        .object("quality", "the quality", QualityCriteriaReader::quality)
        .orElse(QualityCriteria.DEFAULT);
  }

  private static QualityCriteria quality(JsonObjectReader keys) {
    QualityCriteria usual = QualityCriteria.DEFAULT;
    OptionalDouble minFps =
        keys.has("min_fps")
            ? OptionalDouble.of(keys.number("min_fps", 1, MOST_FPS, Double.NaN))
            : OptionalDouble.empty();
    if (minFps.isEmpty() && keys.has("max_slow_frames")) {
      keys.fault("max_slow_frames", "\"max_slow_frames\" needs \"min_fps\"");
    }
    return new QualityCriteria(
        minFps,
        keys.number("max_slow_frames", 0, 1, usual.slowShare()),
        keys.number("max_tracker_silence", 0.1, LONGEST, usual.trackerSilence()),
        exclude(keys));
  }

  private static Set<SessionFlag> exclude(JsonObjectReader keys) {
    Set<SessionFlag> exclude = EnumSet.noneOf(SessionFlag.class);
    for (LocatedJsonValue value : keys.list("exclude", false)) {
      SessionFlag.of(value.toString())
          .ifPresentOrElse(
              exclude::add,
              () ->
                  keys.fault(
                      value,
                      "'%s' is not a flag of a session (%s)"
                          .formatted(
                              value,
                              Arrays.stream(SessionFlag.values())
                                  .map(SessionFlag::spelling)
                                  .collect(Collectors.joining(", ")))));
    }
    return exclude;
  }
}
