package org.selectiverenderer.apartment.plan;

import org.selectiverenderer.modelling.Bounds;

/** The upright box around a placed object, turned with it. */
public record Footprint(Placed placed) {

  /** By how much two boxes reach into each other, metres; 0 or less when they are apart. */
  public double overlap(Footprint other) {
    double vertical = Math.min(top(), other.top()) - Math.max(bottom(), other.bottom());
    double least = vertical;
    for (double axis : new double[] {placed.yaw(), other.placed.yaw()}) {
      for (double turn : new double[] {0, 90}) {
        double[] a = range(axis + turn);
        double[] b = other.range(axis + turn);
        least = Math.min(least, Math.min(a[1], b[1]) - Math.max(a[0], b[0]));
      }
    }
    return least;
  }

  public double bottom() {
    return placed.y() + placed.box().minY();
  }

  public double top() {
    return placed.y() + placed.box().maxY();
  }

  /** Lowest and highest x of the world, or z. */
  public double[] reach(boolean x) {
    return range(x ? 0 : -90);
  }

  /** The box's shadow on the direction that +x takes when turned so far about y. */
  private double[] range(double degrees) {
    double dx = Math.cos(Math.toRadians(degrees));
    double dz = -Math.sin(Math.toRadians(degrees));
    double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    Bounds b = placed.box();
    for (double x : new double[] {b.minX(), b.maxX()}) {
      for (double z : new double[] {b.minZ(), b.maxZ()}) {
        double s = Math.sin(Math.toRadians(placed.yaw()));
        double c = Math.cos(Math.toRadians(placed.yaw()));
        double at = dx * (placed.x() + c * x + s * z) + dz * (placed.z() + c * z - s * x);
        range[0] = Math.min(range[0], at);
        range[1] = Math.max(range[1], at);
      }
    }
    return range;
  }
}
