package org.selectiverenderer.study.definition;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;

/** Reads the keys of a study file that define the procedure of a session. */
final class StudyProcedureReader {
  private StudyProcedureReader() {}

  /** Reads the procedure of the study. */
  static StudyProcedure read(JsonObjectReader keys) {
    StudyProcedure usual = StudyProcedure.USUAL;
    return new StudyProcedure(
        keys.choice("order", List.of(AreaOrder.values()), AreaOrder::spelling, usual.order()),
        stay(keys).orElse(usual.stay()),
        keys.truth("closed", usual.closed()),
        keys.truth("blind", usual.blind()));
  }

  /** Reads the movement constraint of a study or an area; empty if it has none. */
  static Optional<MovementConstraint> stay(JsonObjectReader keys) {
    return keys.has("stay")
        ? Optional.of(
            keys.choice(
                "stay",
                List.of(MovementConstraint.values()),
                MovementConstraint::spelling,
                MovementConstraint.FREE))
        : Optional.empty();
  }

  /** Reads the operator's monitor: its number, counted from 0, or its name. */
  static Optional<String> operator(JsonObjectReader display) {
    Optional<LocatedJsonValue> found = display.value("operator");
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
  static PointerConfinement pointer(JsonObjectReader display) {
    return display.choice(
        "pointer",
        List.of(PointerConfinement.values()),
        PointerConfinement::spelling,
        PointerConfinement.AUTO);
  }
}
