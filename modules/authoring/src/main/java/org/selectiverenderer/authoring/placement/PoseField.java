package org.selectiverenderer.authoring.placement;

import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/** A field of a pose, as an author types it. */
public enum PoseField {
  /** The position. */
  TRANSLATION("translation", FieldType.SFVec3f, "0 0 0"),
  /** The rotation: axis and angle in radians. */
  ROTATION("rotation", FieldType.SFRotation, "0 0 1 0"),
  /** The factors along the axes. */
  SCALE("scale", FieldType.SFVec3f, "1 1 1");

  private final String field;
  private final FieldType type;
  private final String usual;

  PoseField(String field, FieldType type, String usual) {
    this.field = field;
    this.type = type;
    this.usual = usual;
  }

  /** Returns the value that changes nothing. */
  public String usual() {
    return usual;
  }

  /** Returns the value as it is written in the Transform of a placement; empty for none. */
  public String written(Placement placed) {
    return placed.transform().flatMap(transform -> transform.text(field)).orElse("").strip();
  }

  /** Returns the name of the Transform's field. */
  String field() {
    return field;
  }

  /**
   * Returns what an author typed as the field's value: the same numbers, with single spaces; for an
   * empty text the value that changes nothing.
   *
   * @throws EditRejectedException if the text is no value, has no direction of an axis, or would
   *     hide the node for good
   */
  public String value(String text) {
    if (text.isBlank()) {
      return usual;
    }
    check(text);
    return text.strip().replaceAll("[\\s,]+", " ");
  }

  private void check(String text) {
    FieldParser.Parsed parsed = new FieldParser().parse(type, text);
    parsed.flaws().stream()
        .filter(flaw -> flaw.severity() == Problem.Severity.ERROR)
        .findFirst()
        .ifPresent(
            flaw -> {
              throw new EditRejectedException(flaw.message());
            });
    if (!(parsed.value() instanceof float[] v)) {
      throw new EditRejectedException("'%s' is no value of type %s".formatted(text, type));
    }
    for (float number : v) {
      if (!Float.isFinite(number)) {
        throw new EditRejectedException("'%s' has a number that is not finite".formatted(text));
      }
      if (this == SCALE && number == 0) {
        throw new EditRejectedException(
            "a scale of 0 leaves nothing to be seen or moved; delete the node instead");
      }
    }
    if (this == ROTATION && v[0] == 0 && v[1] == 0 && v[2] == 0) {
      throw new EditRejectedException(
          "an axis of 0 0 0 has no direction; write for example 0 1 0 before the angle");
    }
  }
}
