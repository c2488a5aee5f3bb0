package org.selectiverenderer.radiosity.reference;

import java.util.SplittableRandom;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Follows paths of light backwards (Kajiya 1986): at every surface a lamp is tried and a direction
 * is drawn; what both can find is shared between them by the balance heuristic (Veach and Guibas
 * 1995); paths end by Russian roulette. Unbiased. One per thread.
 *
 * <p>Surfaces are diffuse about their interpolated normals, panes let their share straight through,
 * and the back of what has one side throws back nothing.
 */
final class PathTracer {
  /** Surfaces before paths may end by chance. */
  private static final int CERTAIN = 3;

  private static final double LEAST_CHANCE = 0.05;
  private static final double MOST_CHANCE = 0.95;

  private final RadiosityScene scene;
  private final SceneEmitters lights;
  private final Ray ray = new Ray();
  private final SurfacePoint at;
  private final EmitterSample draw = new EmitterSample();
  private final double[] weights;
  private final double[] share = new double[3];
  private final double[] start = new double[3];
  private final double[] direction = new double[3];
  private double weightSum;
  private long met;
  private long metBehind;

  /** The random numbers of the first surface, which a caller may spread evenly. */
  record First(double lamp, double lampS, double lampT, double s, double t) {}

  PathTracer(RadiosityScene scene, SceneEmitters lights) {
    this.scene = scene;
    this.lights = lights;
    at = new SurfacePoint(scene);
    weights = new double[lights.count()];
  }

  /**
   * Adds what a place throws back along one path, r, g, b, cd/m2; its own glow is left out.
   *
   * @param white whether its own reflectance counts as 1: then the sum is irradiance over pi
   */
  void add(
      int triangle,
      double u,
      double v,
      boolean behind,
      boolean white,
      First first,
      SplittableRandom random,
      double[] sum) {
    at.at(triangle, u, v, behind);
    if (!at.front) {
      return;
    }
    for (int i = 0; i < 3; i++) {
      share[i] = white ? 1 : at.albedo[i];
    }
    First numbers = first;
    for (int depth = 1; share[0] + share[1] + share[2] > 0; depth++) {
      for (int axis = 0; axis < 3; axis++) {
        start[axis] = at.place[axis] + scene.offset() * at.flat[axis];
      }
      tryLamp(numbers, sum);
      VectorMath.cosine(at.normal, numbers.s(), numbers.t(), direction);
      if (VectorMath.dot(direction, at.flat) <= 0 || !follow(random.nextDouble(), sum)) {
        return;
      }
      for (int i = 0; i < 3; i++) {
        share[i] *= at.albedo[i];
      }
      if (depth >= CERTAIN && !goesOn(random)) {
        return;
      }
      numbers =
          new First(
              random.nextDouble(),
              random.nextDouble(),
              random.nextDouble(),
              random.nextDouble(),
              random.nextDouble());
    }
  }

  private boolean goesOn(SplittableRandom random) {
    double most = Math.max(share[0], Math.max(share[1], share[2]));
    double chance = Math.max(LEAST_CHANCE, Math.min(MOST_CHANCE, most));
    for (int i = 0; i < 3; i++) {
      share[i] /= chance;
    }
    return random.nextDouble() < chance;
  }

  private void tryLamp(First numbers, double[] sum) {
    weightSum = lights.weigh(start, at.normal, weights);
    if (!(weightSum > 0)) {
      return;
    }
    double wanted = numbers.lamp() * weightSum;
    int lamp = -1;
    for (int i = 0; i < weights.length && wanted >= 0; i++) {
      if (weights[i] > 0) {
        lamp = i;
        wanted -= weights[i];
      }
    }
    if (!lights.get(lamp).draw(start, numbers.lampS(), numbers.lampT(), draw)) {
      return;
    }
    double cosine = VectorMath.dot(draw.towards, at.normal);
    if (cosine <= 0 || VectorMath.dot(draw.towards, at.flat) <= 0) {
      return;
    }
    ray.from(start, draw.towards);
    // A glowing surface is not in its own way.
    ray.length = draw.distance - 4 * scene.offset();
    double passed =
        ray.length > 0 ? scene.visibility().transmittance(ray, ObjectVersionIndex.FIXED) : 1;
    double chance = weights[lamp] / weightSum;
    double density = draw.density > 0 ? chance * draw.density + cosine / Math.PI : chance;
    for (int i = 0; i < 3; i++) {
      sum[i] += share[i] * draw.light[i] * passed * cosine / Math.PI / density;
    }
  }

  /** Goes to what lies in the direction and adds what shines from there; false if nothing. */
  private boolean follow(double pass, double[] sum) {
    ray.from(start, direction);
    ray.length = Double.POSITIVE_INFINITY;
    ray.pass = pass;
    scene.visibility().nearest(ray, ObjectVersionIndex.FIXED);
    boolean any = ray.triangle != Ray.NOTHING;
    double density = VectorMath.dot(direction, at.normal) / Math.PI;
    for (int lamp : lights.rectangles()) {
      Emitter.Rectangle rectangle = lights.rectangle(lamp);
      double distance = rectangle.crossing(start, direction);
      if (distance < (any ? ray.length : Double.POSITIVE_INFINITY)) {
        double other = chance(lamp) * rectangle.density(distance, direction);
        for (int i = 0; i < 3; i++) {
          sum[i] += share[i] * rectangle.lamp().luminance()[i] * density / (density + other);
        }
      }
    }
    if (!any) {
      return false;
    }
    double distance = ray.length;
    at.at(ray);
    met++;
    if (!at.front) {
      metBehind++;
      return false;
    }
    int lamp = lights.ofBody(at.body);
    if (lamp != SceneEmitters.NONE) {
      double area = ((Emitter.Glow) lights.get(lamp)).body().area();
      double other =
          chance(lamp) * distance * distance / (area * -VectorMath.dot(direction, at.flat));
      for (int i = 0; i < 3; i++) {
        sum[i] += share[i] * at.glow[i] * density / (density + other);
      }
    }
    return true;
  }

  private double chance(int lamp) {
    return weightSum > 0 ? weights[lamp] / weightSum : 0;
  }

  /** The share of surfaces met from behind. */
  double behind() {
    return met == 0 ? 0 : (double) metBehind / met;
  }

  long rays() {
    return ray.cast();
  }
}
