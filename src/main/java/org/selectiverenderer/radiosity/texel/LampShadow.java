package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.DirectLight;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * The share of a lamp's light that reaches a texel, by shadow rays from all over its square to all
 * over the lamp: shadows' edges are as smooth as the lamp is wide, and as the texel. One per
 * thread.
 */
final class LampShadow {
  /** No share: nothing of the lamp's light falls on the texel, even if nothing is in the way. */
  static final double NOTHING = -1;

  /** Shares closer to none or all than this have no edge in them. */
  private static final double CLEAR = 0.01;

  private final boolean[] hard;
  private final Points points;
  private final DirectLight lamps;
  private final Ray ray = new Ray();
  private final double[] start = new double[3];
  private double open;
  private double passed;

  /**
   * What all share.
   *
   * @param onLamp places on a lamp
   * @param onTexel starts
   */
  record Points(PointSet onLamp, PointSet onTexel) {
    static Points of(int most, int seed) {
      return new Points(new PointSet(most, seed, 20), new PointSet(most, seed, 21));
    }

    int most() {
      return onLamp.size();
    }
  }

  LampShadow(LightScene scene, Points points) {
    this.points = points;
    lamps = new DirectLight(scene, ray);
    hard = new boolean[scene.lamps().size()];
    for (int i = 0; i < hard.length; i++) {
      hard[i] = scene.lamps().get(i).hard();
    }
  }

  long rays() {
    return ray.cast();
  }

  /** The share where nothing is known yet, by few rays if they agree. */
  double share(TexelPlace place, int lamp, int turn) {
    return share(place, lamp, hard[lamp] ? 4 : 16, points.most(), turn);
  }

  /**
   * The share where an edge may be. Of a hard shadow's all rays are needed to place it; a soft
   * one's is taken together with those of the texels around.
   */
  double edge(TexelPlace place, int lamp, int turn) {
    return hard[lamp]
        ? share(place, lamp, points.most(), points.most(), turn)
        : share(place, lamp, points.most() / 8, points.most() / 4, turn);
  }

  /** The share on a piece of few texels, on which little of a half-shadow can be seen. */
  double small(TexelPlace place, int lamp, int turn) {
    return share(place, lamp, 4, points.most() / 4, turn);
  }

  private double share(TexelPlace place, int lamp, int first, int most, int turn) {
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

  /** The share by one ray. */
  double one(TexelPlace place, int lamp, int i, int turn) {
    open = 0;
    passed = 0;
    cast(place, lamp, i, i + 1, turn);
    return open > 0 ? passed / open : NOTHING;
  }

  /**
   * @param turn shifts the points, another number another way
   */
  private void cast(TexelPlace place, int lamp, int from, int to, int turn) {
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
    return (PointSet.hash(of) >>> 8) * 0x1p-24;
  }

  private static double turned(double value, double by) {
    double sum = value + by;
    return sum >= 1 ? sum - 1 : sum;
  }
}
