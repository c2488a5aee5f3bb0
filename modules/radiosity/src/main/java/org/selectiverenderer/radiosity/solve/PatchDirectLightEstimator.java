package org.selectiverenderer.radiosity.solve;

import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Estimates the direct irradiance from the lamps on a patch: the mean over several sample points of
 * the patch, each with a shadow ray to another point of every lamp. For a lamp that is near
 * compared to its size the shadow rays give the visible share only, and the unshadowed irradiance
 * is computed in closed form. One per thread.
 */
final class PatchDirectLightEstimator {
  private final RadiosityScene scene;
  private final SurfacePatches patches;
  private final SobolPointSet starts;
  private final SobolPointSet onLamps;
  private final DirectLightEstimator shadows;

  // The sample points of the present patch, with their normals and versions.
  private final double[][] points;
  private final double[][] normals;
  private final int[] versions;

  private double lampS;
  private double lampT;
  private final double[] all = new double[3];
  private final double[] one = new double[3];
  private final double[] open = new double[3];

  /**
   * @param starts points on a patch
   * @param onLamps points on a lamp, one for each point on the patch
   */
  PatchDirectLightEstimator(
      RadiosityScene scene,
      SurfacePatches patches,
      Ray ray,
      SobolPointSet starts,
      SobolPointSet onLamps) {
    this.scene = scene;
    this.patches = patches;
    this.starts = starts;
    this.onLamps = onLamps;
    shadows = new DirectLightEstimator(scene, ray);
    points = new double[starts.size()][3];
    normals = new double[starts.size()][3];
    versions = new int[starts.size()];
  }

  /**
   * Estimates the direct irradiance on a patch.
   *
   * @param shift rotation of the point sets, from 0 to 1
   * @param direct irradiance r, g, b of each patch, lx; receives that of this patch
   * @return bit i: whether light arrived from lamp i
   */
  long light(int patch, float shift, float[] direct) {
    place(patch, shift);
    lampS = shift(shift, 1);
    lampT = shift(shift, 2);
    Arrays.fill(all, 0);
    long lit = 0;
    List<LightSource> lamps = scene.lamps();
    for (int i = 0; i < lamps.size(); i++) {
      if (add(i, lamps.get(i))) {
        lit |= i < Long.SIZE ? 1L << i : 0;
      }
    }
    for (int c = 0; c < 3; c++) {
      direct[3 * patch + c] = (float) (all[c] / starts.size());
    }
    return lit;
  }

  /**
   * Derives a different rotation for each dimension: otherwise all patches would miss the same
   * parts of a lamp, and the flux that arrives from all lamps would be biased.
   */
  private static double shift(float shift, int dimension) {
    int bits = SobolPointSet.hash(Float.floatToIntBits(shift) + 0x51ed270b * dimension);
    return (bits >>> 8) * 0x1p-24;
  }

  private void place(int patch, float shift) {
    for (int i = 0; i < versions.length; i++) {
      int triangle =
          patches.place(
              patch,
              SobolPointSet.turned(onLamps.y(i), shift),
              SobolPointSet.turned(starts.x(i), shift),
              starts.y(i),
              points[i],
              normals[i]);
      for (int axis = 0; axis < 3; axis++) {
        points[i][axis] += scene.offset() * normals[i][axis];
      }
      versions[i] = scene.triangles().version()[triangle];
    }
  }

  /** Adds a lamp's light at all sample points; returns whether there is any. */
  private boolean add(int number, LightSource lamp) {
    double tried = 0;
    double passed = 0;
    boolean near = false;
    Arrays.fill(one, 0);
    for (int i = 0; i < versions.length; i++) {
      // Each lamp is sampled at different points.
      double s = SobolPointSet.turned(onLamps.x(i), lampS) + number * 0.618034;
      double t = SobolPointSet.turned(onLamps.y(i), lampT);
      double cosine = shadows.aim(number, points[i], normals[i], s - Math.floor(s), t);
      near |= shadows.distance() < lamp.near();
      if (cosine > 0) {
        double share = shadows.passed(points[i], versions[i]);
        double light = cosine * shadows.aimed();
        tried += light;
        passed += share * light;
        shadows.addAimed(share * cosine, one);
      }
    }
    if (!(passed > 0)) {
      return false;
    }
    if (near) {
      unshadowed(lamp, passed / tried);
    }
    for (int c = 0; c < 3; c++) {
      all[c] += one[c];
    }
    return true;
  }

  private void unshadowed(LightSource lamp, double share) {
    Arrays.fill(one, 0);
    for (int i = 0; i < versions.length; i++) {
      lamp.unshadowed(points[i], normals[i], open);
      for (int c = 0; c < 3; c++) {
        one[c] += share * open[c];
      }
    }
  }
}
