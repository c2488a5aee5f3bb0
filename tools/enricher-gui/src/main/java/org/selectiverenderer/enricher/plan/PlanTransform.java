package org.selectiverenderer.enricher.plan;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * The transform from the ground plane (world X and Z) to the screen: X to the right, Z down.
 *
 * @param left world X at the left edge
 * @param top world Z at the upper edge
 * @param scale pixels per metre, above 0
 */
record PlanTransform(double left, double top, double scale) {
  private static final double MARGIN = 0.06;

  /** Returns the transform that fits a box into a component of a size, with a margin. */
  static PlanTransform fitting(BoundingBox all, int width, int height) {
    double w = Math.max(1e-3, all.width()) * (1 + 2 * MARGIN);
    double d = Math.max(1e-3, all.depth()) * (1 + 2 * MARGIN);
    double scale = Math.max(1e-6, Math.min(width / w, height / d));
    return new PlanTransform(
        (all.minX() + all.maxX()) / 2 - width / scale / 2,
        (all.minZ() + all.maxZ()) / 2 - height / scale / 2,
        scale);
  }

  double x(double screen) {
    return left + screen / scale;
  }

  double z(double screen) {
    return top + screen / scale;
  }

  double toX(double x) {
    return (x - left) * scale;
  }

  double toY(double z) {
    return (z - top) * scale;
  }

  Rectangle2D rectangle(BoundingBox of) {
    return new Rectangle2D.Double(
        toX(of.minX()), toY(of.minZ()), of.width() * scale, of.depth() * scale);
  }

  PlanTransform shifted(double dx, double dy) {
    return new PlanTransform(left - dx / scale, top - dy / scale, scale);
  }

  /** Zooms about a pixel, which keeps its world position. */
  PlanTransform zoomed(double factor, double atX, double atY) {
    double next = scale * factor;
    return new PlanTransform(x(atX) - atX / next, z(atY) - atY / next, next);
  }

  BoundingBox seen(Rectangle of) {
    return new BoundingBox(
        x(of.getMinX()), 0, z(of.getMinY()), x(of.getMaxX()), 0, z(of.getMaxY()));
  }
}
