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
 * @param edge longest, but of narrow triangles
 * @param sight longest edge as a share of the distance from the eye, endless where that never shows
 * @param bent size of triangles above which they are split for their normals
 */
record Fineness(double cosine, double edge, double sight, double bent) {
  /** Departures of that much show only beside each other: 6 of 255 levels. */
  private static final double HIGHLIGHT = 6.0 / 255;

  /** The cosine of an angle between normals that shows as facets even without a highlight. */
  static final double WIDE = Math.cos(Math.toRadians(15));

  /** That of one which shows only in highlights. */
  static final double NARROW = Math.cos(Math.toRadians(10));

  /** The distance from which a shape is seen by vertex, where the highlights let it. */
  private static final double NEAR = 0.5;

  /** Shorter edges are not asked for: what is nearer to them is lit by pixel. */
  private static final double SHORTEST = 0.1;

  /** What is bent within two hundredths of a unit is small in every picture. */
  private static final double BENT = 0.02;

  /** From so many times its length an edge is too small for its bend to be seen. */
  private static final double BENT_SIGHT = 15;

  private static final double ENDLESS = Double.POSITIVE_INFINITY;

  /** What every mesh has. */
  static final Fineness NONE = new Fineness(-2, ENDLESS, ENDLESS, ENDLESS);

  /** What a lit surface needs, in the lengths of the world. */
  static Fineness of(Surface surface) {
    float[] s = surface.specular();
    double strength = Math.max(s[0], Math.max(s[1], s[2])) * Math.max(1, 128 * surface.shininess());
    if (strength / 32 <= HIGHLIGHT) {
      return new Fineness(WIDE, ENDLESS, ENDLESS, BENT);
    }
    double angle = Math.sqrt(8 * HIGHLIGHT / strength);
    double sight = Math.sqrt(32 * HIGHLIGHT / strength);
    return new Fineness(
        Math.cos(angle) > WIDE ? NARROW : WIDE, Math.max(SHORTEST, NEAR * sight), sight, BENT);
  }

  /**
   * The same for a mesh in its own coordinates, whose lengths are {@code scale} times as long in
   * the world. Rounded down to a power of two, so that meshes of many scales stay few.
   */
  Fineness local(double scale) {
    return new Fineness(cosine, rounded(edge / scale), sight, rounded(bent / scale));
  }

  /**
   * Whether a mesh is coarser.
   *
   * @param scale of the world's lengths to the mesh's
   */
  boolean finerThan(MeshSurvey mesh, double scale) {
    return mesh.bent(cosine) * scale > bent || mesh.largest() * scale > edge;
  }

  /** The distance from which on a mesh is seen to be fine enough, in the world. */
  double nearest(MeshSurvey mesh, double scale) {
    return scale * Math.max(mesh.largest() / sight, mesh.bent(cosine) * BENT_SIGHT);
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
