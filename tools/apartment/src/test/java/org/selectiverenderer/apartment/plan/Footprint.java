package org.selectiverenderer.apartment.plan;

import java.util.List;
import org.selectiverenderer.geometry.BoundingBox;

/** An upright box around a placed object or a piece of it, turned with it. */
public record Footprint(PlacedObject placed, BoundingBox box) {

  /** Around all of the object. */
  public Footprint(PlacedObject placed) {
    this(placed, placed.box());
  }

  /** Around each of its pieces that hang together. */
  public static List<Footprint> pieces(PlacedObject placed) {
    return ConnectedPieces.boxes(placed.model()).stream()
        .map(b -> new Footprint(placed, b))
        .toList();
  }

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
    return placed.y() + box.minY();
  }

  public double top() {
    return placed.y() + box.maxY();
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
    for (double x : new double[] {box.minX(), box.maxX()}) {
      for (double z : new double[] {box.minZ(), box.maxZ()}) {
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
