package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.modelling.Bounds;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;

/** Puts models where a plan expects them, and measures from the y axis. */
final class Standing {

  private Standing() {}

  /** The model of these parts moved so that it stands on y = 0, centred on x and z. */
  static Model centred(String name, Part... parts) {
    Model model = Model.of(name, parts);
    Bounds b = model.bounds();
    double x = (b.minX() + b.maxX()) / 2;
    double z = (b.minZ() + b.maxZ()) / 2;
    return model.map(mesh -> mesh.move(-x, -b.minY(), -z));
  }

  /** The distance from the y axis; {@link Math#hypot} need not be the same on every machine. */
  static double fromAxis(double x, double z) {
    return Math.sqrt(x * x + z * z);
  }
}
