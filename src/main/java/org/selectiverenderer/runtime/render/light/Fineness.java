package org.selectiverenderer.runtime.render.light;

import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.instance.Surface;

/**
 * How fine a surface is to be so that nobody sees that its light is computed at the vertices.
 *
 * <p>Between two vertices a highlight of exponent e that is bent by an angle a departs from a
 * straight line by up to e a a / 8 of its strength. The angle is that between two normals, or half
 * of that under which an eye or a light sees an edge of a flat face.
 *
 * @param cosine least, of the angle between the normals of an edge's ends
 * @param edge longest
 * @param sight longest edge as a share of the distance from the eye, endless where that never shows
 * @param bent shortest edge that is split for its normals
 */
public record Fineness(double cosine, double edge, double sight, double bent) {
  /** Departures of that much show only beside each other: 3 of 255 levels. */
  private static final double HIGHLIGHT = 3.0 / 255;

  /** Wider angles show as facets even without a highlight. */
  private static final double WIDEST = Math.toRadians(14);

  /** Narrower ones cost more than they show. */
  private static final double NARROWEST = Math.toRadians(7);

  /** The distance from which a shape is seen by vertex, where the highlights let it. */
  private static final double NEAR = 0.8;

  /** Shorter edges are not asked for: what is nearer to them is lit by pixel. */
  private static final double SHORTEST = 0.08;

  /** What is bent within a hundredth of a unit is small in every picture. */
  private static final double BENT = 0.01;

  private static final double ENDLESS = Double.POSITIVE_INFINITY;

  /** What every mesh has. */
  static final Fineness NONE = new Fineness(-2, ENDLESS, ENDLESS, ENDLESS);

  /** What a lit surface needs, in the lengths of the world. */
  static Fineness of(Surface surface) {
    float[] s = surface.specular();
    double strength = Math.max(s[0], Math.max(s[1], s[2])) * Math.max(1, 128 * surface.shininess());
    if (strength / 32 <= HIGHLIGHT) {
      return new Fineness(Math.cos(WIDEST), ENDLESS, ENDLESS, BENT);
    }
    double angle = Math.sqrt(8 * HIGHLIGHT / strength);
    double sight = Math.sqrt(32 * HIGHLIGHT / strength);
    return new Fineness(
        Math.cos(Math.max(NARROWEST, Math.min(WIDEST, angle))),
        Math.max(SHORTEST, NEAR * sight),
        sight,
        BENT);
  }

  /**
   * The same for a mesh in its own coordinates, whose lengths are {@code scale} times as long in
   * the world. Rounded down to a power of two, so that meshes of many scales stay few.
   */
  Fineness local(double scale) {
    return new Fineness(cosine, rounded(edge / scale), sight, rounded(bent / scale));
  }

  /** The same where lights that are near show otherwise. */
  Fineness seen(double otherSight) {
    return new Fineness(cosine, edge, otherSight, bent);
  }

  /** How many times as long as in its own coordinates a length can be in the world. */
  static double scale(Matrix4dc world) {
    double x = Math.sqrt(sum(world.m00(), world.m01(), world.m02()));
    double y = Math.sqrt(sum(world.m10(), world.m11(), world.m12()));
    double z = Math.sqrt(sum(world.m20(), world.m21(), world.m22()));
    return Math.max(x, Math.max(y, z));
  }

  private static double sum(double x, double y, double z) {
    return x * x + y * y + z * z;
  }

  private static double rounded(double length) {
    return Double.isFinite(length) ? Math.scalb(1.0, Math.getExponent(length)) : length;
  }
}
