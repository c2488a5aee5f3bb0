package org.selectiverenderer.browser.collision;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Moves a sphere among obstacles by collision and sliding response. The sphere's centre stays at
 * least the radius away from every obstacle; it is pushed out along the shortest way, so that the
 * component of the motion along a wall remains. If the sphere already is too near (a wall has
 * appeared, a door closes), it may not get nearer and moves away gradually.
 *
 * <p>A step must be shorter than the radius. No step ever leads through an obstacle.
 */
public final class CollisionResponse {
  /** Largest number of pushes in one step; a corner of several walls needs a few. */
  private static final int PUSHES = 24;

  private final ObstacleSet barrier;
  private final double radius;
  private final double[] kept;
  private final Vector3d[] away;
  private final Vector3d q = new Vector3d();

  private CollisionResponse(ObstacleSet barrier, Vector3dc from, double radius) {
    this.barrier = barrier;
    this.radius = radius;
    kept = new double[barrier.size()];
    away = new Vector3d[barrier.size()];
    for (int i = 0; i < kept.length; i++) {
      barrier.nearest(i, from, q);
      kept[i] = Math.min(radius, from.distance(q));
      away[i] = from.sub(q, new Vector3d());
    }
  }

  /**
   * Returns the end point of a step.
   *
   * @param by the desired step
   * @param relax how far the sphere may move away, in this step, from obstacles that it is too near
   *     to
   */
  public static Vector3d step(
      Vector3dc from, Vector3dc by, double radius, double relax, ObstacleSet barrier) {
    CollisionResponse slide = new CollisionResponse(barrier, from, radius);
    Vector3d to = new Vector3d();
    if (slide.tryStep(from, by, relax, to) || slide.tryStep(from, by, 0, to)) {
      return to;
    }
    return to.set(from);
  }

  private boolean tryStep(Vector3dc from, Vector3dc by, double relax, Vector3d to) {
    from.add(by, to);
    for (int push = 0; push < PUSHES && pushOut(from, relax, to); push++) {
      // Repeat until no obstacle pushes any more.
    }
    double tolerance = 1e-6 * radius;
    for (int i = 0; i < kept.length; i++) {
      barrier.nearest(i, to, q);
      if (q.distance(to) < kept[i] - tolerance || passes(i, from, to)) {
        barrier.touched(i);
        return false;
      }
    }
    return true;
  }

  /**
   * Returns whether an obstacle lies between two points; false for one on which the sphere's centre
   * lies.
   */
  private boolean passes(int piece, Vector3dc from, Vector3dc to) {
    return kept[piece] > 1e-9 * radius && barrier.crossed(piece, from, to);
  }

  /** Moves the sphere out of the obstacle that penetrates it most; returns false if none does. */
  private boolean pushOut(Vector3dc from, double relax, Vector3d to) {
    double deepest = 1e-9 * radius;
    int piece = -1;
    boolean through = false;
    for (int i = 0; i < kept.length; i++) {
      double required = Math.min(radius, kept[i] + relax);
      boolean passed = passes(i, from, to);
      barrier.nearest(i, to, q);
      double distance = q.distance(to);
      double depth = passed ? required + distance : required - distance;
      if (depth > deepest) {
        deepest = depth;
        piece = i;
        through = passed;
      }
    }
    if (piece < 0) {
      return false;
    }
    barrier.touched(piece);
    double required = Math.min(radius, kept[piece] + relax);
    if (through) {
      // Push back to the side that the sphere came from, seen from its nearest point.
      Vector3d n = away[piece].normalize(new Vector3d());
      Vector3d surface = from.sub(away[piece], new Vector3d());
      to.fma(required - to.sub(surface, surface).dot(n), n);
      return true;
    }
    barrier.nearest(piece, to, q);
    Vector3d n = to.sub(q, new Vector3d());
    if (n.lengthSquared() < 1e-24 * radius * radius) {
      n.set(away[piece]);
    }
    if (n.lengthSquared() == 0) {
      return false;
    }
    to.fma(deepest, n.normalize());
    return true;
  }
}
