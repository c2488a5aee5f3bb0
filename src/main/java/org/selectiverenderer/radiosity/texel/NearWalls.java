package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * What stands on a surface around a place, as the rays from there tell it: on the other side of it
 * other light may fall, however thin it is. To each of four sides the nearest is kept, as the plane
 * that it stands in. One per thread.
 */
final class NearWalls {
  /** Numbers by place: four vectors. */
  static final int NUMBERS = 12;

  /** How far away walls count, and how far above the surface rays may meet them, texels. */
  private static final double FAR = 8;

  private static final double LOW = 3;

  /**
   * Cosine of the angle between the normals of a wall and of the surface: what rises by less than
   * 45 degrees is part of the surface.
   */
  private static final double LEANS = 0.7;

  /** Nearer than this share of a texel they count as so near. */
  private static final double LEAST = 1e-6;

  private final LightScene scene;
  private final double[] across = new double[3];
  private final double[] along = new double[3];
  private final double[] normal = new double[3];
  private double[] surface = new double[3];
  private double texel;

  /**
   * To each side a vector along the surface, from the wall to the place, of length one over how far
   * it is, 1/m; 0 where there is none.
   */
  private final float[] planes = new float[NUMBERS];

  NearWalls(LightScene scene) {
    this.scene = scene;
  }

  /**
   * Begins at a place; nothing is known to be near.
   *
   * @param upright the unit normal there
   * @param size of its texel, metres
   */
  void begin(double[] upright, double size) {
    surface = upright;
    texel = size;
    Tangents.of(upright, across, along);
    Arrays.fill(planes, 0);
  }

  /** Takes what a ray from the place has met, from either side. */
  void met(Ray ray) {
    double up = ray.dx * surface[0] + ray.dy * surface[1] + ray.dz * surface[2];
    if (ray.length > (FAR + LOW) * texel || ray.length * up > LOW * texel) {
      return;
    }
    scene.triangles().normal(ray.triangle, normal);
    double leans = normal[0] * surface[0] + normal[1] * surface[1] + normal[2] * surface[2];
    if (!(Math.abs(leans) < LEANS)) {
      return;
    }
    double side = ray.behind ? -1 : 1;
    double flat = side / Math.sqrt(1 - leans * leans);
    double x = flat * (normal[0] - leans * surface[0]);
    double y = flat * (normal[1] - leans * surface[1]);
    double z = flat * (normal[2] - leans * surface[2]);
    double away = -ray.length * (x * ray.dx + y * ray.dy + z * ray.dz);
    if (away > 0 && away < FAR * texel) {
      keep(x, y, z, 1 / Math.max(LEAST * texel, away));
    }
  }

  private void keep(double x, double y, double z, double near) {
    double a = x * across[0] + y * across[1] + z * across[2];
    double b = x * along[0] + y * along[1] + z * along[2];
    // Most walls stand at right angles: the middle of each side lies along one of both tangents.
    int to = 3 * ((a + b > 0 ? 1 : 0) + (a - b > 0 ? 2 : 0));
    if (near * near > square(planes, to)) {
      planes[to] = (float) (near * x);
      planes[to + 1] = (float) (near * y);
      planes[to + 2] = (float) (near * z);
    }
  }

  private static double square(float[] all, int at) {
    return (double) all[at] * all[at]
        + (double) all[at + 1] * all[at + 1]
        + (double) all[at + 2] * all[at + 2];
  }

  /** Writes the numbers of the place. */
  void write(float[] out) {
    System.arraycopy(planes, 0, out, 0, NUMBERS);
  }

  /** Takes what more rays from the same place have found. */
  static void join(float[] all, int at, float[] more) {
    for (int i = 0; i < NUMBERS; i += 3) {
      if (square(more, i) > square(all, at + i)) {
        System.arraycopy(more, i, all, at + i, 3);
      }
    }
  }

  /**
   * Whether a wall stands in front of another place.
   *
   * @param at where the numbers of the first place begin
   * @param dx with {@code dy} and {@code dz} from the first place to the other, metres
   */
  static boolean between(float[] all, int at, double dx, double dy, double dz) {
    for (int i = at; i < at + NUMBERS; i += 3) {
      if (dx * all[i] + dy * all[i + 1] + dz * all[i + 2] < -1) {
        return true;
      }
    }
    return false;
  }
}
