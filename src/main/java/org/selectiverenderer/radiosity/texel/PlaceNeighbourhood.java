package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.DirectLight;
import org.selectiverenderer.radiosity.trace.Ray;

/** What is around a place: how near it is, and whether anybody sees the place. One per thread. */
final class PlaceNeighbourhood {
  /** Of the offset of starts: the rest is the place itself. */
  private static final double OVERLAID = 0.9;

  /** Rays that say whether a place lies in a hollow, and how wide hollows are, texels. */
  private static final int HOLLOW_RAYS = 32;

  private static final double HOLLOW = 12;

  private static final int FEW = 4;

  /** Places on each lamp to know whether it shines into a hollow. */
  private static final int LAMP_TRIES = 4;

  private final LightScene scene;
  private final HitLight hits;
  private final TexelRays rays;
  private final Ray ray;
  private final DirectLight lamps;
  private final double[] light = new double[3];

  PlaceNeighbourhood(LightScene scene, HitLight hits, TexelRays.Sets sets) {
    this.scene = scene;
    this.hits = hits;
    rays = new TexelRays(scene, sets);
    ray = rays.ray;
    lamps = new DirectLight(scene, ray);
  }

  /** Rays of one set. */
  int most() {
    return rays.most();
  }

  /** Rays cast so far. */
  long rays() {
    return ray.cast();
  }

  /**
   * How many texels away one ray ends, if that is within some texels; else infinite.
   *
   * @param turn which set of directions
   */
  double near(TexelPlace place, int i, int turn, double most) {
    rays.begin(place, turn);
    boolean met = rays.cast(i, most * place.size(), 0.5) && ray.triangle != Ray.NOTHING;
    return met ? ray.length / place.size() : Double.POSITIVE_INFINITY;
  }

  /** Whether a place lies inside of something or is covered closely, as few rays tell. */
  boolean unseen(TexelPlace place, int count, int turn) {
    rays.begin(place, turn);
    int backs = 0;
    int near = 0;
    int valid = 0;
    for (int i = 0; i < count; i++) {
      if (rays.cast(i)) {
        valid++;
        boolean met = ray.triangle != Ray.NOTHING;
        backs += met && ray.behind && !rays.twoSided() ? 1 : 0;
        near += met && ray.length < Hemisphere.TOUCHING * scene.offset() ? 1 : 0;
      }
    }
    return 2 * backs >= valid && backs > 0 || near == valid && near > 0;
  }

  /**
   * Whether a place lies in a closed hollow without a lamp. Nobody sees it, as light would come in
   * where eyes look in; and none does if nothing that is sent out from there gets far, however
   * often it is thrown back. Light that was found before is not asked: beside the hollow's edge it
   * is interpolated, and may be that of the other side.
   */
  boolean hollow(TexelPlace place, int turn) {
    double wide = HOLLOW * place.size();
    rays.begin(place, turn);
    int most = Math.min(HOLLOW_RAYS, rays.most());
    int sent = 0;
    // Most places are told by a few rays that are not followed.
    for (int follow = 0; follow <= Hemisphere.MOST_BOUNCES; follow += Hemisphere.MOST_BOUNCES) {
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

  /** Whether a sheet lies on the place, so near that rays start beyond it: nobody sees it. */
  boolean overlaid(TexelPlace place) {
    rays.begin(place, 0);
    rays.castBack(OVERLAID * scene.offset());
    return ray.triangle != Ray.NOTHING;
  }

  /** Whether the ray, or what is thrown back where it ends, comes to a lamp or goes far. */
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

  /** Whether some place of a lamp is seen from the middle of a texel. */
  private boolean lit(TexelPlace place) {
    Arrays.fill(light, 0);
    for (int i = 0; i < LAMP_TRIES; i++) {
      double s = (i + 0.5) / LAMP_TRIES;
      double t = (i * 0.618034 + 0.5) % 1;
      if (lamps.add(rays.start, place.normal, place.version, s, t, DirectLight.ALL, light) != 0) {
        return true;
      }
    }
    return light[0] + light[1] + light[2] > 0;
  }
}
