package org.selectiverenderer.radiosity.solve;

import org.selectiverenderer.radiosity.sampling.Directions;
import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.trace.Ray;
import org.selectiverenderer.radiosity.trace.SceneTriangles;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * What every patch sees, found once by rays that leave it as light does from a diffuse surface: the
 * share of them that meets a patch is the form factor to it (thesis Fig 13, Nusselt's analog; rays
 * for the hemicube: Malley 1988, Wallace et al. 1989). Also the light straight from the lamps.
 */
public final class Transport {
  /** The ray left the scene. */
  public static final int OUTSIDE = -1;

  /** The ray met a surface from behind: its start lies inside of something. */
  public static final int INSIDE = -2;

  private final LightPatches patches;
  private final int rays;
  private final int[] seen;
  private final float[] direct;
  private final long[] lampsOf;
  private final long cast;

  private Transport(
      LightPatches patches, int rays, int[] seen, float[] direct, long[] lampsOf, long cast) {
    this.patches = patches;
    this.rays = rays;
    this.seen = seen;
    this.direct = direct;
    this.lampsOf = lampsOf;
    this.cast = cast;
  }

  /**
   * @param rays per patch
   * @param lampPlaces per patch and lamp
   * @return what the patches see; if cancelled, what was found so far, the rest being dark
   */
  public static Transport find(
      LightScene scene,
      LightPatches patches,
      int rays,
      int lampPlaces,
      int seed,
      WorkProgress progress) {
    int count = patches.count();
    int[] seen = new int[Math.multiplyExact(count, rays)];
    java.util.Arrays.fill(seen, INSIDE);
    float[] direct = new float[3 * count];
    long[] lampsOf = new long[count];
    Directions directions = new Directions(new PointSet(rays, seed, 0));
    PointSet places = new PointSet(rays, seed, 1);
    PointSet others = new PointSet(rays, seed, 2);
    PointSet lampSet = new PointSet(lampPlaces, seed, 3);
    PointSet starts = new PointSet(lampPlaces, seed, 4);
    java.util.concurrent.atomic.LongAdder cast = new java.util.concurrent.atomic.LongAdder();
    ParallelWork.run(
        count,
        256,
        progress,
        WorkProgress.Stage.TRANSPORT,
        (from, to) -> {
          Ray ray = new Ray();
          Caster caster = new Caster(scene, patches, ray);
          for (int patch = from; patch < to; patch++) {
            // Each patch has its own shift of the sets: errors of neighbours must not agree.
            float shift = (PointSet.hash(patch + 31 * seed) >>> 8) * 0x1p-24f;
            for (int i = 0; i < rays; i++) {
              seen[patch * rays + i] = caster.see(patch, i, directions, places, others, shift);
            }
            lampsOf[patch] = caster.light(patch, starts, lampSet, shift, direct);
          }
          cast.add(ray.cast());
        });
    return new Transport(patches, rays, seen, direct, lampsOf, cast.sum());
  }

  /** One thread's work. */
  private static final class Caster {
    private final LightScene scene;
    private final LightPatches patches;
    private final SceneTriangles triangles;
    private final Ray ray;
    private final DirectLight shadows;
    private final double[] point = new double[3];
    private final double[] normal = new double[3];
    private final double[] direction = new double[3];
    private final double[] sum = new double[3];

    Caster(LightScene scene, LightPatches patches, Ray ray) {
      this.scene = scene;
      this.patches = patches;
      this.triangles = scene.triangles();
      this.ray = ray;
      this.shadows = new DirectLight(scene, ray);
    }

    private int start(int patch, double pick, double s, double t) {
      int triangle = patches.place(patch, pick, s, t, point, normal);
      for (int axis = 0; axis < 3; axis++) {
        point[axis] += scene.offset() * normal[axis];
      }
      return triangle;
    }

    int see(
        int patch, int i, Directions directions, PointSet places, PointSet others, float shift) {
      int triangle = start(patch, turn(others.x(i), shift), turn(places.x(i), shift), places.y(i));
      directions.about(normal, i, direction);
      ray.from(point, direction);
      ray.length = Double.POSITIVE_INFINITY;
      ray.pass = turn(others.y(i), shift);
      scene.visibility().nearest(ray, triangles.version()[triangle]);
      if (ray.triangle == Ray.NOTHING) {
        return OUTSIDE;
      }
      if (ray.behind && !triangles.twoSided()[ray.triangle]) {
        return INSIDE;
      }
      return patches.at(ray.triangle, ray.u, ray.v, ray.behind);
    }

    long light(int patch, PointSet starts, PointSet lampSet, float shift, float[] direct) {
      java.util.Arrays.fill(sum, 0);
      long lit = 0;
      for (int i = 0; i < starts.size(); i++) {
        int triangle =
            start(patch, turn(lampSet.y(i), shift), turn(starts.x(i), shift), starts.y(i));
        lit |=
            shadows.add(
                point,
                normal,
                triangles.version()[triangle],
                turn(lampSet.x(i), shift),
                lampSet.y(i),
                DirectLight.ALL,
                sum);
      }
      for (int c = 0; c < 3; c++) {
        direct[3 * patch + c] = (float) (sum[c] / starts.size());
      }
      return lit;
    }

    private static double turn(double value, double shift) {
      double sum = value + shift;
      return sum >= 1 ? sum - 1 : sum;
    }
  }

  public LightPatches patches() {
    return patches;
  }

  public int rays() {
    return rays;
  }

  /** The patch that the i-th ray of a patch met, {@link #OUTSIDE} or {@link #INSIDE}. */
  public int seen(int patch, int i) {
    return seen[patch * rays + i];
  }

  /** Irradiance from the lamps, r, g, b per patch, lx. */
  public float[] direct() {
    return direct;
  }

  /** Per patch, bit i: whether it sees some of lamp i. */
  public long[] lampsOf() {
    return lampsOf;
  }

  /** The share of light that leaves one patch and arrives at another. */
  public double formFactor(int patch, int other) {
    int met = 0;
    for (int i = 0; i < rays; i++) {
      met += seen(patch, i) == other ? 1 : 0;
    }
    return (double) met / rays;
  }

  /** Rays cast. */
  public long cast() {
    return cast;
  }
}
