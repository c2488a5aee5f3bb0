package org.selectiverenderer.modelling;

import org.selectiverenderer.geometry.BoundingBox;

/**
 * Moves models to the position that a floor plan expects, and measures distances from the y axis.
 */
public final class ModelPlacement {

  private ModelPlacement() {}

  /**
   * Returns the model moved so that it stands on y = 0 with its bounding box centred on x and z.
   */
  public static ParametricModel centred(ParametricModel model) {
    BoundingBox b = model.bounds();
    double x = (b.minX() + b.maxX()) / 2;
    double z = (b.minZ() + b.maxZ()) / 2;
    return model.map(mesh -> mesh.move(-x, -b.minY(), -z));
  }

  /**
   * Returns the model of these parts, moved so that it stands on y = 0 with its bounding box
   * centred on x and z.
   */
  public static ParametricModel centred(String name, Part... parts) {
    return centred(ParametricModel.of(name, parts));
  }

  /**
   * Returns the distance from the y axis; {@link Math#hypot} need not be the same on every machine.
   */
  public static double fromAxis(double x, double z) {
    return Math.sqrt(x * x + z * z);
  }
}
