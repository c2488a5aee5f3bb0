package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Monte Carlo estimator of the indirect irradiance at a surface point from all surfaces visible
 * over its hemisphere. One per thread.
 */
final class HemisphereIrradianceEstimator {
  /** Number of batches of rays whose means are compared to estimate the standard error. */
  private static final int PARTS = 8;

  /** Share of rays that hit back faces above which a point lies inside of a solid. */
  private static final double BURIED = 0.25;

  /**
   * A point is covered when at least this share of its rays ends within {@link #TOUCHING} ray
   * offsets: another surface lies right on it. Through a wider gap the point is visible, and
   * rightly dark.
   */
  private static final double COVERED = 0.95;

  static final double TOUCHING = 4;

  /** Largest number of reflections that a ray follows between surfaces close to each other. */
  static final int MOST_BOUNCES = 4;

  /**
   * Least cosine by which the rotational gradient is divided, so that grazing rays do not dominate
   * it.
   */
  private static final double LEAST_COSINE = 0.1;

  private final RadiosityScene scene;
  private final HitRadiance hits;
  private final TexelRayCaster rays;
  private final Ray ray;
  private final double[] radiance = new double[3];
  private final double[] toward = new double[3];
  private final double[] fromSurfaces = new double[3];
  private final double[] share = new double[3];
  private final double[] light = new double[3];
  private final double[] reflected = new double[3];
  private final double[] parts = new double[PARTS];
  private final NearbyWallPlanes walls;

  HemisphereIrradianceEstimator(RadiosityScene scene, HitRadiance hits, TexelRayCaster.Sets sets) {
    this.scene = scene;
    this.hits = hits;
    rays = new TexelRayCaster(scene, sets);
    ray = rays.ray;
    walls = new NearbyWallPlanes(scene);
  }

  /** Returns the number of rays cast so far. */
  long rays() {
    return ray.cast();
  }

  /**
   * Estimates the irradiance at a surface point.
   *
   * @param turn chooses the set of directions
   * @param fewer divisor of the number of rays: 1 for all, 2 for half and so on
   */
  void gather(TexelSurfacePoint place, int turn, int fewer, IrradianceRecord out) {
    int count = Math.max(PARTS, rays.most() / fewer);
    Arrays.fill(out.light, 0);
    Arrays.fill(out.turn, 0);
    rays.begin(place, turn);
    walls.begin(place.normal, place.size());
    double inverse = 0;
    int valid = 0;
    int backs = 0;
    int near = 0;
    int met = 0;
    for (int part = 0; part < PARTS; part++) {
      double sum = 0;
      int counted = 0;
      for (int i = part * count / PARTS; i < (part + 1) * count / PARTS; i++) {
        if (!rays.cast(i)) {
          continue;
        }
        if (ray.triangle == Ray.NOTHING) {
          counted++;
          continue;
        }
        walls.met(ray);
        if (ray.behind && !rays.twoSided()) {
          backs++;
          continue;
        }
        counted++;
        near += ray.length < TOUCHING * scene.offset() ? 1 : 0;
        met++;
        inverse += 1 / Math.max(1e-6, ray.length);
        System.arraycopy(rays.direction, 0, toward, 0, 3);
        look(i);
        sum += radiance[0] + radiance[1] + radiance[2];
        add(place.normal, out);
      }
      parts[part] = counted == 0 ? 0 : sum / counted;
      valid += counted;
    }
    out.rays = count;
    walls.write(out.walls);
    out.seen = backs <= BURIED * (backs + valid) && near < COVERED * valid;
    finish(valid, out);
    out.distance = inverse > 0 ? met / inverse : Double.POSITIVE_INFINITY;
  }

  /**
   * Computes the radiance of the surface that the ray hit. Where the hit is near, as in a corner or
   * under furniture, the patch is too coarse for the indirect light there, and a further ray
   * follows the reflection.
   */
  private void look(int i) {
    Arrays.fill(radiance, 0);
    Arrays.fill(share, 1);
    for (int bounce = 0; ; bounce++) {
      int patch = hits.patch(ray);
      hits.reflectance(ray, reflected);
      hits.direct(ray, patch, light);
      boolean goesOn = bounce < MOST_BOUNCES && hits.near(ray, patch);
      if (!goesOn) {
        hits.indirect(patch, fromSurfaces);
      }
      for (int c = 0; c < 3; c++) {
        double arriving = light[c] + (goesOn ? 0 : fromSurfaces[c]);
        radiance[c] += share[c] * (hits.glow(patch, c) + reflected[c] * arriving / Math.PI);
        share[c] *= reflected[c];
      }
      if (!goesOn || !rays.bounce(i, bounce)) {
        return;
      }
    }
  }

  private void add(double[] n, IrradianceRecord out) {
    double cosine = TexelRayCaster.dot(toward, n);
    double scale = 1 / Math.max(LEAST_COSINE, cosine);
    for (int c = 0; c < 3; c++) {
      out.light[c] += radiance[c];
      for (int axis = 0; axis < 3; axis++) {
        out.turn[3 * c + axis] += radiance[c] * scale * (toward[axis] - cosine * n[axis]);
      }
    }
  }

  private void finish(int valid, IrradianceRecord out) {
    double scale = valid == 0 ? 0 : Math.PI / valid;
    for (int c = 0; c < 3; c++) {
      out.light[c] *= scale;
    }
    for (int i = 0; i < 9; i++) {
      out.turn[i] *= scale;
    }
    double mean = Arrays.stream(parts).sum() / PARTS;
    double squares = 0;
    for (double part : parts) {
      squares += (part - mean) * (part - mean);
    }
    out.error = Math.PI * Math.sqrt(squares / (PARTS * (PARTS - 1)));
  }
}
