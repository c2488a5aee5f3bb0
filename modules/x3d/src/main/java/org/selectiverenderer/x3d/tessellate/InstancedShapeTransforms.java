package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Computes the transforms of an InstancedShape's instances (X_ITE 11), each T C R SR S -SR -C as in
 * a Transform. A list shorter than the longest repeats its last value; an empty one has the default
 * of a Transform.
 */
public final class InstancedShapeTransforms {
  private static final float[] NOWHERE = {0, 0, 0};
  private static final float[] UNTURNED = {0, 0, 1, 0};
  private static final float[] AS_LARGE = {1, 1, 1};

  private InstancedShapeTransforms() {}

  /** Returns the number of instances, the length of the longest list. */
  public static int count(NodeView shape) {
    int most = shape.floats("translations").length / 3;
    most = Math.max(most, shape.floats("rotations").length / 4);
    most = Math.max(most, shape.floats("scales").length / 3);
    most = Math.max(most, shape.floats("scaleOrientations").length / 4);
    return Math.max(most, shape.floats("centers").length / 3);
  }

  /**
   * Returns the transform of each instance from the geometry's coordinates to the shape's.
   *
   * @param most the maximum number of instances
   */
  public static List<Matrix4d> of(NodeView shape, int most) {
    float[] t = shape.floats("translations");
    float[] c = shape.floats("centers");
    float[] r = shape.floats("rotations");
    float[] s = shape.floats("scales");
    float[] sr = shape.floats("scaleOrientations");
    int count = Math.min(count(shape), most);
    List<Matrix4d> places = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      places.add(
          TransformMatrix.of(
              new Matrix4d(),
              value(t, i, NOWHERE),
              value(c, i, NOWHERE),
              value(r, i, UNTURNED),
              value(s, i, AS_LARGE),
              value(sr, i, UNTURNED)));
    }
    return places;
  }

  private static float[] value(float[] list, int index, float[] missing) {
    int size = missing.length;
    if (list.length < size) {
      return missing;
    }
    int at = Math.min(index, list.length / size - 1) * size;
    float[] value = new float[size];
    System.arraycopy(list, at, value, 0, size);
    return value;
  }
}
