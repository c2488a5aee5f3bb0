package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.DirectLightEstimator;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Probes the surroundings of a surface point with rays: the distance to other surfaces, and whether
 * the point can be visible at all. One per thread.
 */
final class TexelOcclusionProbe {
  /**
   * Share of the ray offset within which a hit counts as a covering sheet; beyond it lies the
   * point's own surface.
   */
  private static final double OVERLAID = 0.9;

  /**
   * Number of rays that test whether a point lies in a closed cavity, and the largest width of a
   * cavity, texels.
   */
  private static final int HOLLOW_RAYS = 32;

  private static final double HOLLOW = 12;

  private static final int FEW = 4;

  /** Number of sample points on each lamp that test whether it shines into a cavity. */
  private static final int LAMP_TRIES = 4;

  private final RadiosityScene scene;
  private final HitRadiance hits;
  private final TexelRayCaster rays;
  private final Ray ray;
  private final DirectLightEstimator lamps;
  private final double[] light = new double[3];

  TexelOcclusionProbe(RadiosityScene scene, HitRadiance hits, TexelRayCaster.Sets sets) {
    this.scene = scene;
    this.hits = hits;
    rays = new TexelRayCaster(scene, sets);
    ray = rays.ray;
    lamps = new DirectLightEstimator(scene, ray);
  }

  /** Returns the number of rays of one set. */
  int most() {
    return rays.most();
  }

  /** Returns the number of rays cast so far. */
  long rays() {
    return ray.cast();
  }

  /**
   * Casts one ray; returns the distance of its hit in texels, or infinity if it hits nothing within
   * {@code most} texels.
   *
   * @param turn chooses the set of directions
   */
  double near(TexelSurfacePoint place, int i, int turn, double most) {
    rays.begin(place, turn);
    boolean met = rays.cast(i, most * place.size(), 0.5) && ray.triangle != Ray.NOTHING;
    return met ? ray.length / place.size() : Double.POSITIVE_INFINITY;
  }

  /** Returns whether a point lies inside of a solid or is covered closely, as few rays tell. */
  boolean unseen(TexelSurfacePoint place, int count, int turn) {
    rays.begin(place, turn);
    int backs = 0;
    int near = 0;
    int valid = 0;
    for (int i = 0; i < count; i++) {
      if (rays.cast(i)) {
        valid++;
        boolean met = ray.triangle != Ray.NOTHING;
        backs += met && ray.behind && !rays.twoSided() ? 1 : 0;
        near += met && ray.length < HemisphereIrradianceEstimator.TOUCHING * scene.offset() ? 1 : 0;
      }
    }
    return 2 * backs >= valid && backs > 0 || near == valid && near > 0;
  }

  /**
   * Returns whether a point lies in a closed cavity without a lamp. Such a point is invisible,
   * since light would enter where eyes look in, and none does if no path that starts there gets
   * far, however often it is reflected. Light computed before is not used: beside the cavity's edge
   * it is interpolated, and may be that of the other side.
   */
  boolean hollow(TexelSurfacePoint place, int turn) {
    double wide = HOLLOW * place.size();
    rays.begin(place, turn);
    int most = Math.min(HOLLOW_RAYS, rays.most());
    int sent = 0;
    // For most points a few rays without reflections are enough.
    for (int follow = 0;
        follow <= HemisphereIrradianceEstimator.MOST_BOUNCES;
        follow += HemisphereIrradianceEstimator.MOST_BOUNCES) {
      for (int i = 0; i < (follow == 0 ? FEW : most); i++) {
        if (rays.cast(i)) {
          if (getsOut(i, follow, wide)) {
            return false;
          }
          sent++;
        }
      }
    }
    return sent > 0 && !lit(place);
  }

  /**
   * Returns whether a sheet lies on the point, so near that rays start beyond it and would miss it.
   */
  boolean overlaid(TexelSurfacePoint place) {
    rays.begin(place, 0);
    rays.castBack(OVERLAID * scene.offset());
    return ray.triangle != Ray.NOTHING;
  }

  /** Returns whether the path that begins with the ray reaches an emissive surface or gets far. */
  private boolean getsOut(int i, int follow, double most) {
    for (int bounce = 0; ; bounce++) {
      if (far(most) || glows(hits.patch(ray))) {
        return true;
      }
      if (bounce == follow || !rays.turnBack(i, bounce)) {
        return far(most);
      }
    }
  }

  private boolean glows(int patch) {
    return hits.glow(patch, 0) + hits.glow(patch, 1) + hits.glow(patch, 2) > 0;
  }

  private boolean far(double most) {
    return ray.triangle == Ray.NOTHING || ray.length > most;
  }

  /** Returns whether some sample point of a lamp is visible from the middle of a texel. */
  private boolean lit(TexelSurfacePoint place) {
    Arrays.fill(light, 0);
    for (int i = 0; i < LAMP_TRIES; i++) {
      double s = (i + 0.5) / LAMP_TRIES;
      double t = (i * 0.618034 + 0.5) % 1;
      if (lamps.add(rays.start, place.normal, place.version, s, t, DirectLightEstimator.ALL, light)
          != 0) {
        return true;
      }
    }
    return light[0] + light[1] + light[2] > 0;
  }
}
