package org.selectiverenderer.apartment.plan;

import java.util.Arrays;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * An object at its position: first rotated about y by yaw degrees, then translated; y is above the
 * floor. Rounded to a tenth of a millimetre, as in the scene's file.
 */
public record PlacedObject(
    PlannedObject placement, ParametricModel model, double x, double y, double z, double yaw) {

  public PlacedObject {
    x = rounded(x);
    y = rounded(y);
    z = rounded(z);
  }

  private static double rounded(double value) {
    return DecimalRounding.to(4, value);
  }

  public String object() {
    return placement.object();
  }

  /** Returns its triangles in the coordinates of the plan. */
  public TriangleMesh mesh() {
    return model.mesh().turnY(yaw).move(x, y, z);
  }

  /** Returns its bounding box in its own coordinates, before rotation and translation. */
  public BoundingBox box() {
    return model.bounds();
  }

  /**
   * Returns the bounding box of its points up to a height above its lowest one, in its own
   * coordinates.
   */
  public BoundingBox lowerBox(double height) {
    double limit = box().minY() + height;
    float[] all = model.mesh().positions();
    float[] low = new float[all.length];
    int n = 0;
    for (int i = 0; i < all.length; i += 3) {
      if (all[i + 1] <= limit) {
        System.arraycopy(all, i, low, n, 3);
        n += 3;
      }
    }
    return BoundingBox.around(Arrays.copyOf(low, n));
  }
}
