package org.selectiverenderer.x3d.read;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The unit of angles in a file, given by a UNIT statement (X3D 4.0, 4.3.6). Angles are converted to
 * radians when they are read; the defaults of the catalogue are in radians.
 *
 * @param factor radians per unit
 */
record AngleUnit(double factor) {
  static final AngleUnit RADIANS = new AngleUnit(1);

  /** The names of float fields that are angles; rotations are recognized by their type. */
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

  /** Returns the unit of a UNIT statement; radians for an invalid conversion factor. */
  static AngleUnit of(double factor) {
    return factor > 0 && factor < Double.POSITIVE_INFINITY ? new AngleUnit(factor) : RADIANS;
  }

  /**
   * Converts the value of a node field to radians if it is an angle.
   *
   * @param node the type of the node; the fieldOfView of an OrthoViewpoint consists of lengths
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

  /** Converts the value of a prototype field, of which only rotations are known to be angles. */
  @Nullable Object radians(FieldType type, @Nullable Object value) {
    boolean rotation = type == FieldType.SFRotation || type == FieldType.MFRotation;
    return factor == 1 || value == null || !rotation ? value : scaled((float[]) value, 3, 4);
  }

  /** Returns a scaled copy, since the document may keep the parsed value. */
  private float[] scaled(float[] values, int first, int step) {
    float[] scaled = values.clone();
    for (int i = first; i < scaled.length; i += step) {
      scaled[i] = (float) (scaled[i] * factor);
    }
    return scaled;
  }
}
