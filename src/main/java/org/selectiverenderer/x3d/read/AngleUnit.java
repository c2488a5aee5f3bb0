package org.selectiverenderer.x3d.read;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The unit of angles that a file states (X3D 4.0, 4.3.6). Values of the file become radians when
 * they are read, so that nobody else needs to know; a catalogue's defaults are radians anyway.
 *
 * @param factor radians per unit
 */
record AngleUnit(double factor) {
  static final AngleUnit RADIANS = new AngleUnit(1);

  /** The fields of numbers that are angles; rotations are known by their type. */
  private static final Set<String> ANGLES =
      Set.of(
          "angle",
          "axis1Angle",
          "axis2Angle",
          "axis3Angle",
          "beamWidth",
          "coneInnerAngle",
          "coneOuterAngle",
          "creaseAngle",
          "cutOffAngle",
          "diskAngle",
          "endAngle",
          "fieldOfView",
          "groundAngle",
          "llimit",
          "maxAngle",
          "maxAngle1",
          "minAngle",
          "minAngle1",
          "rotation",
          "skyAngle",
          "startAngle",
          "ulimit");

  /** That of a unit statement; radians for a factor that is none. */
  static AngleUnit of(double factor) {
    return factor > 0 && factor < Double.POSITIVE_INFINITY ? new AngleUnit(factor) : RADIANS;
  }

  /**
   * A value of a field in radians.
   *
   * @param node the type of its node; an OrthoViewpoint's fieldOfView are lengths
   */
  @Nullable Object radians(String node, FieldDefinition field, @Nullable Object value) {
    if (factor == 1 || value == null) {
      return value;
    }
    boolean angle = ANGLES.contains(field.name()) && !node.equals("OrthoViewpoint");
    if (angle && field.type() == FieldType.SFFloat) {
      return (float) ((Float) value * factor);
    }
    return angle && field.type() == FieldType.MFFloat
        ? scaled((float[]) value, 0, 1)
        : radians(field.type(), value);
  }

  /** A value of a prototype's field: there only rotations are known to be angles. */
  @Nullable Object radians(FieldType type, @Nullable Object value) {
    boolean rotation = type == FieldType.SFRotation || type == FieldType.MFRotation;
    return factor == 1 || value == null || !rotation ? value : scaled((float[]) value, 3, 4);
  }

  /** A copy, since what was parsed may be kept by its document. */
  private float[] scaled(float[] values, int first, int step) {
    float[] scaled = values.clone();
    for (int i = first; i < scaled.length; i += step) {
      scaled[i] = (float) (scaled[i] * factor);
    }
    return scaled;
  }
}
