package org.selectiverenderer.authoring.placement;

import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
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

  /**
   * Returns the placement with another value of the field; an empty text is the value that changes
   * nothing.
   *
   * @throws EditRejectedException if the text is no value, or would hide the node for good
   */
  public Placement set(Placement placed, String text) {
    float[] v = parsed(text.isBlank() ? usual : text);
    TransformPose pose = placed.pose();
    Vector3dc translation = this == TRANSLATION ? vector(v) : pose.translation();
    Quaterniondc rotation = this == ROTATION ? TransformPose.rotation(v) : pose.rotation();
    Vector3dc scale = this == SCALE ? vector(v) : pose.scale();
    return placed.with(
        new TransformPose(translation, pose.center(), rotation, scale, pose.scaleOrientation()));
  }

  private float[] parsed(String text) {
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
    return v;
  }

  private static Vector3d vector(float[] v) {
    return new Vector3d(v[0], v[1], v[2]);
  }
}
