package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.sampling.CosineHemisphereSampler;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Casts rays from the middle of a texel over its hemisphere, and follows reflections from their
 * hits. One per thread.
 */
final class TexelRayCaster {
  /**
   * Number of different sets of directions, so that the errors of neighbours are not correlated.
   */
  private static final int SETS = 64;

  /**
   * Least cosine between a direction and the geometric normal; flatter directions may leave to the
   * back of the triangle.
   */
  private static final double FLAT = 0.005;

  private final RadiosityScene scene;
  private final Sets sets;
  private final double[] bounced = new double[3];
  private final double[] hitNormal = new double[3];
  private TexelSurfacePoint place;
  private int first;

  /** The ray that was cast last. */
  final Ray ray = new Ray();

  /** Start of the rays, off the surface. */
  final double[] start = new double[3];

  /** Direction of the last ray. */
  final double[] direction = new double[3];

  /** The sets of directions, shared by all threads. */
  record Sets(CosineHemisphereSampler directions, SobolPointSet passes, int rays) {
    static Sets of(int rays, int seed) {
      return new Sets(
          new CosineHemisphereSampler(new SobolPointSet(SETS * rays, seed, 22)),
          new SobolPointSet(SETS * rays, seed, 23),
          rays);
    }
  }

  TexelRayCaster(RadiosityScene scene, Sets sets) {
    this.scene = scene;
    this.sets = sets;
  }

  /** Returns the number of rays of one set. */
  int most() {
    return sets.rays();
  }

  /**
   * Begins at a surface point, which must not be moved meanwhile.
   *
   * @param turn chooses the set of directions
   */
  void begin(TexelSurfacePoint from, int turn) {
    place = from;
    first = (SobolPointSet.hash(turn) & SETS - 1) * sets.rays();
    place.start(start);
  }

  /** Casts a ray of the set; returns false if it would leave to the back of the triangle. */
  boolean cast(int i) {
    return cast(i, Double.POSITIVE_INFINITY, sets.passes().x(first + i));
  }

  /**
   * Casts a ray of the set up to a length; it passes triangles that transmit more than {@code
   * pass}. Returns false if it would leave to the back of the triangle.
   */
  boolean cast(int i, double length, double pass) {
    sets.directions().about(place.normal, first + i, direction);
    if (dot(direction, place.facing) < FLAT) {
      return false;
    }
    send(start, place.version, length, pass);
    return true;
  }

  /** Casts a ray back to the surface. */
  void castBack(double length) {
    for (int axis = 0; axis < 3; axis++) {
      direction[axis] = -place.facing[axis];
    }
    send(start, place.version, length, 0.5);
  }

  /** Returns whether the triangle that the ray hit is two-sided. */
  boolean twoSided() {
    return scene.triangles().twoSided()[ray.triangle];
  }

  /**
   * Continues the ray in a random direction from its hit; returns false if it hits nothing or the
   * back of a one-sided triangle.
   *
   * @param bounce number of reflections before this one
   */
  boolean bounce(int i, int bounce) {
    faceHit();
    bounced[0] = ray.ox + ray.length * ray.dx + scene.offset() * hitNormal[0];
    bounced[1] = ray.oy + ray.length * ray.dy + scene.offset() * hitNormal[1];
    bounced[2] = ray.oz + ray.length * ray.dz + scene.offset() * hitNormal[2];
    return sendOn(i, bounce);
  }

  /**
   * Continues the ray as {@link #bounce} does, but from a start just before its hit: in a gap less
   * than an offset wide, an offset start could lie beyond another surface.
   */
  boolean turnBack(int i, int bounce) {
    double length = ray.length - Math.min(scene.offset(), ray.length) / 2;
    bounced[0] = ray.ox + length * ray.dx;
    bounced[1] = ray.oy + length * ray.dy;
    bounced[2] = ray.oz + length * ray.dz;
    faceHit();
    return sendOn(i, bounce);
  }

  private void faceHit() {
    scene.triangles().normal(ray.triangle, hitNormal);
    for (int axis = 0; axis < 3; axis++) {
      hitNormal[axis] *= ray.behind ? -1 : 1;
    }
  }

  private boolean sendOn(int i, int bounce) {
    int turn = SobolPointSet.hash(first + i + 0x632be5ab * (bounce + 1));
    int next = (turn >>> 1) % sets.directions().size();
    sets.directions().about(hitNormal, next, direction);
    send(bounced, place.version, Double.POSITIVE_INFINITY, sets.passes().y(next));
    return ray.triangle != Ray.NOTHING && (!ray.behind || twoSided());
  }

  private void send(double[] from, int version, double length, double pass) {
    ray.from(from, direction);
    ray.length = length;
    ray.pass = pass;
    scene.visibility().nearest(ray, version);
  }

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
