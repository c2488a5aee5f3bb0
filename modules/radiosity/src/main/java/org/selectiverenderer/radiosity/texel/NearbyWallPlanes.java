package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * The planes of walls that stand on a surface near a point, as found by the rays from there. A
 * record must not be used on the other side of a wall, however thin it is, since other light may
 * fall there. For each of four directions along the surface the nearest wall is kept. One per
 * thread.
 */
final class NearbyWallPlanes {
  /** Numbers per point: four vectors. */
  static final int NUMBERS = 12;

  /**
   * Largest distance of a wall from the point, and largest height above the surface at which rays
   * may hit it, texels.
   */
  private static final double FAR = 8;

  private static final double LOW = 3;

  /**
   * Largest cosine of the angle between the normals of a wall and of the surface: what rises by
   * less than 45 degrees is part of the surface.
   */
  private static final double LEANS = 0.7;

  /** Least distance of a wall, as a share of a texel; nearer walls count as that far. */
  private static final double LEAST = 1e-6;

  private final RadiosityScene scene;
  private final double[] across = new double[3];
  private final double[] along = new double[3];
  private final double[] normal = new double[3];
  private double[] surface = new double[3];
  private double texel;

  /**
   * For each direction a vector along the surface from the wall to the point, with the inverse
   * distance as its length, 1/m; 0 where there is no wall.
   */
  private final float[] planes = new float[NUMBERS];

  NearbyWallPlanes(RadiosityScene scene) {
    this.scene = scene;
  }

  /**
   * Begins at a point without walls.
   *
   * @param upright the unit normal of the surface
   * @param size side of the point's texel, metres
   */
  void begin(double[] upright, double size) {
    surface = upright;
    texel = size;
    TangentFrame.of(upright, across, along);
    Arrays.fill(planes, 0);
  }

  /** Takes the triangle that a ray from the point hit, from either side. */
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
    // Most walls are at right angles to each other, so each quadrant is centred on one of both
    // tangents.
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

  /** Writes the numbers of the point. */
  void write(float[] out) {
    System.arraycopy(planes, 0, out, 0, NUMBERS);
  }

  /** Merges the walls that further rays from the same point found. */
  static void join(float[] all, int at, float[] more) {
    for (int i = 0; i < NUMBERS; i += 3) {
      if (square(more, i) > square(all, at + i)) {
        System.arraycopy(more, i, all, at + i, 3);
      }
    }
  }

  /**
   * Returns whether a wall near a first point separates it from a second point.
   *
   * @param at index at which the numbers of the first point begin
   * @param dx with {@code dy} and {@code dz} the vector from the first point to the second, metres
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
