package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.DirectLightEstimator;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Estimates the visible share of a lamp at a texel with shadow rays from points all over the
 * texel's square to points all over the lamp, so that the edges of shadows are as soft as the
 * lamp's size makes them and are antialiased over the texel. One per thread.
 */
final class LightVisibilityEstimator {
  /** Marks a texel that receives no light of the lamp even if nothing occludes it. */
  static final double NOTHING = -1;

  /** Shares closer to 0 or 1 than this have no shadow edge in them. */
  private static final double CLEAR = 0.01;

  private final boolean[] hard;
  private final Points points;
  private final DirectLightEstimator lamps;
  private final Ray ray = new Ray();
  private final double[] start = new double[3];
  private double open;
  private double passed;

  /**
   * The point sets that all threads share.
   *
   * @param onLamp sample points on a lamp
   * @param onTexel start points on a texel
   */
  record Points(SobolPointSet onLamp, SobolPointSet onTexel) {
    static Points of(int most, int seed) {
      return new Points(new SobolPointSet(most, seed, 20), new SobolPointSet(most, seed, 21));
    }

    int most() {
      return onLamp.size();
    }
  }

  LightVisibilityEstimator(RadiosityScene scene, Points points) {
    this.points = points;
    lamps = new DirectLightEstimator(scene, ray);
    hard = new boolean[scene.lamps().size()];
    for (int i = 0; i < hard.length; i++) {
      hard[i] = scene.lamps().get(i).hard();
    }
  }

  long rays() {
    return ray.cast();
  }

  /** Estimates the share where nothing is known yet, with few rays if they agree. */
  double share(TexelSurfacePoint place, int lamp, int turn) {
    return share(place, lamp, hard[lamp] ? 4 : 16, points.most(), turn);
  }

  /**
   * Estimates the share where a shadow edge may be. A hard edge needs all rays to be located; a
   * soft edge is filtered with the texels around and needs fewer.
   */
  double edge(TexelSurfacePoint place, int lamp, int turn) {
    return hard[lamp]
        ? share(place, lamp, points.most(), points.most(), turn)
        : share(place, lamp, points.most() / 8, points.most() / 4, turn);
  }

  /** Estimates the share on a chart of few texels, on which little of a penumbra is visible. */
  double small(TexelSurfacePoint place, int lamp, int turn) {
    return share(place, lamp, 4, points.most() / 4, turn);
  }

  private double share(TexelSurfacePoint place, int lamp, int first, int most, int turn) {
    open = 0;
    passed = 0;
    int few = Math.min(most, first);
    cast(place, lamp, 0, few, turn);
    if (!(open > 0)) {
      return NOTHING;
    }
    double share = passed / open;
    if (share > CLEAR && share < 1 - CLEAR) {
      cast(place, lamp, few, most, turn);
      share = passed / open;
    }
    return share;
  }

  /** Estimates the share with one ray. */
  double one(TexelSurfacePoint place, int lamp, int i, int turn) {
    open = 0;
    passed = 0;
    cast(place, lamp, i, i + 1, turn);
    return open > 0 ? passed / open : NOTHING;
  }

  /**
   * @param turn chooses the rotation of the point sets
   */
  private void cast(TexelSurfacePoint place, int lamp, int from, int to, int turn) {
    double a = unit(turn);
    double b = unit(turn + 0x51ed270b);
    double c = unit(turn + 0x2545f491);
    double d = unit(turn + 0x3c6ef372);
    for (int i = from; i < to; i++) {
      place.start(turned(points.onTexel().x(i), c), turned(points.onTexel().y(i), d), start);
      double s = turned(points.onLamp().x(i), a);
      double t = turned(points.onLamp().y(i), b);
      double weight = lamps.aim(lamp, start, place.normal, s, t) * lamps.aimed();
      if (weight > 0) {
        open += weight;
        passed += weight * lamps.passed(start, place.version);
      }
    }
  }

  private static double unit(int of) {
    return (SobolPointSet.hash(of) >>> 8) * 0x1p-24;
  }

  private static double turned(double value, double by) {
    double sum = value + by;
    return sum >= 1 ? sum - 1 : sum;
  }
}
