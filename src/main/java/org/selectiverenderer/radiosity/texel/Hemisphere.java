package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.sampling.Directions;
import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Rays from one place to all that it sees. One per thread. */
final class Hemisphere {
  /** Different sets of directions: neighbours' errors must not agree. */
  private static final int SETS = 64;

  /** Parts of a set that are compared to know its error. */
  private static final int PARTS = 8;

  /** A place that meets so many backs, as a share of its rays, lies inside of something. */
  private static final double BURIED = 0.25;

  /** Covered: so many of the rays end within half a texel. */
  private static final double COVERED = 0.95;

  /** Directions flatter than this leave the triangle to its back. */
  private static final double FLAT = 0.005;

  /** Of flat rays no more than this counts for how light turns, as a cosine. */
  private static final double LEAST_COSINE = 0.1;

  private final LightScene scene;
  private final HitLight hits;
  private final Sets sets;
  private final Ray ray = new Ray();
  private final double[] start = new double[3];
  private final double[] direction = new double[3];
  private final double[] radiance = new double[3];
  private final double[] parts = new double[PARTS];

  /** Directions that all share. */
  record Sets(Directions directions, PointSet passes, int rays) {
    static Sets of(int rays, int seed) {
      return new Sets(
          new Directions(new PointSet(SETS * rays, seed, 22)),
          new PointSet(SETS * rays, seed, 23),
          rays);
    }
  }

  Hemisphere(LightScene scene, HitLight hits, Sets sets) {
    this.scene = scene;
    this.hits = hits;
    this.sets = sets;
  }

  long rays() {
    return ray.cast();
  }

  /**
   * Gathers at a place.
   *
   * @param turn which set of directions
   * @param fewer what share of the rays is cast: 1 for all, 2 for half and so on
   */
  void gather(TexelPlace place, int turn, int fewer, LightRecord out) {
    int rays = Math.max(PARTS, sets.rays() / fewer);
    int first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    Arrays.fill(out.light, 0);
    Arrays.fill(out.turn, 0);
    place.start(start);
    double inverse = 0;
    int valid = 0;
    int backs = 0;
    int near = 0;
    for (int part = 0; part < PARTS; part++) {
      double sum = 0;
      int counted = 0;
      for (int i = part * rays / PARTS; i < (part + 1) * rays / PARTS; i++) {
        if (!cast(place, first + i)) {
          continue;
        }
        if (ray.triangle != Ray.NOTHING && ray.behind && !twoSided()) {
          backs++;
          continue;
        }
        counted++;
        if (ray.triangle == Ray.NOTHING) {
          continue;
        }
        near += ray.length < place.size() / 2 ? 1 : 0;
        inverse += 1 / Math.max(1e-6, ray.length);
        hits.of(ray, radiance);
        sum += radiance[0] + radiance[1] + radiance[2];
        add(place.normal, out);
      }
      parts[part] = counted == 0 ? 0 : sum / counted;
      valid += counted;
    }
    out.seen = backs <= BURIED * (backs + valid) && near < COVERED * valid;
    finish(valid, inverse, out);
  }

  /** Whether a place lies inside of something or is covered closely, as few rays tell. */
  boolean unseen(TexelPlace place, int rays, int turn) {
    int first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    place.start(start);
    int backs = 0;
    int near = 0;
    int valid = 0;
    for (int i = 0; i < rays; i++) {
      if (cast(place, first + i)) {
        valid++;
        boolean met = ray.triangle != Ray.NOTHING;
        backs += met && ray.behind && !twoSided() ? 1 : 0;
        near += met && ray.length < place.size() / 2 ? 1 : 0;
      }
    }
    return 2 * backs >= valid && backs > 0 || near == valid && near > 0;
  }

  private boolean cast(TexelPlace place, int i) {
    sets.directions().about(place.normal, i, direction);
    double[] n = place.facing;
    if (direction[0] * n[0] + direction[1] * n[1] + direction[2] * n[2] < FLAT) {
      return false;
    }
    ray.from(start, direction);
    ray.length = Double.POSITIVE_INFINITY;
    ray.pass = sets.passes().x(i);
    scene.visibility().nearest(ray, place.version);
    return true;
  }

  private boolean twoSided() {
    return scene.triangles().twoSided()[ray.triangle];
  }

  private void add(double[] n, LightRecord out) {
    double cosine = direction[0] * n[0] + direction[1] * n[1] + direction[2] * n[2];
    double scale = 1 / Math.max(LEAST_COSINE, cosine);
    for (int c = 0; c < 3; c++) {
      out.light[c] += radiance[c];
      for (int axis = 0; axis < 3; axis++) {
        out.turn[3 * c + axis] += radiance[c] * scale * (direction[axis] - cosine * n[axis]);
      }
    }
  }

  private void finish(int valid, double inverse, LightRecord out) {
    double scale = valid == 0 ? 0 : Math.PI / valid;
    for (int c = 0; c < 3; c++) {
      out.light[c] *= scale;
    }
    for (int i = 0; i < 9; i++) {
      out.turn[i] *= scale;
    }
    out.distance = inverse > 0 ? valid / inverse : Double.POSITIVE_INFINITY;
    double mean = Arrays.stream(parts).sum() / PARTS;
    double squares = 0;
    for (double part : parts) {
      squares += (part - mean) * (part - mean);
    }
    out.error = Math.PI * Math.sqrt(squares / (PARTS * (PARTS - 1)));
  }
}
