package org.selectiverenderer.experiment.study;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.json.JsonMembers;
import org.selectiverenderer.base.json.JsonValue;

/** Reads the keys of a study file that define the procedure of a session. */
final class CourseReader {
  private CourseReader() {}

  /** Reads the procedure of the study. */
  static StudyCourse read(JsonMembers keys) {
    StudyCourse usual = StudyCourse.USUAL;
    return new StudyCourse(
        keys.choice("order", List.of(AreaOrder.values()), AreaOrder::spelling, usual.order()),
        stay(keys).orElse(usual.stay()),
        keys.truth("closed", usual.closed()),
        keys.truth("blind", usual.blind()));
  }

  /** Reads the movement constraint of a study or an area; empty if it has none. */
  static Optional<Stay> stay(JsonMembers keys) {
    return keys.has("stay")
        ? Optional.of(keys.choice("stay", List.of(Stay.values()), Stay::spelling, Stay.FREE))
        : Optional.empty();
  }

  /** Reads the operator's monitor: its number, counted from 0, or its name. */
  static Optional<String> operator(JsonMembers display) {
    Optional<JsonValue> found = display.value("operator");
    if (found.isEmpty()) {
      return Optional.empty();
    }
    double number = found.get().number();
    if (number >= 0 && number < 100 && number == Math.rint(number)) {
      return Optional.of(Integer.toString((int) number));
    }
    Optional<String> name = found.get().text().filter(text -> !text.isBlank());
    if (name.isEmpty()) {
      display.fault(
          "operator",
          "\"operator\" must be the number of a monitor, from 0, or its name in quotes");
    }
    return name;
  }

  /** Reads where the mouse pointer is while a scene is shown. */
  static PointerPlace pointer(JsonMembers display) {
    return display.choice(
        "pointer", List.of(PointerPlace.values()), PointerPlace::spelling, PointerPlace.AUTO);
  }
}
