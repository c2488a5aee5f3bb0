package org.selectiverenderer.radiosity.solve;

import java.util.Arrays;
import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.sampling.CosineHemisphereSampler;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * The form factors of all patches, sampled once by cosine-distributed rays: the share of a patch's
 * rays that hit another patch is the form factor to it (thesis Fig 13, Nusselt's analog; rays in
 * place of the hemicube: Malley 1988, Wallace et al. 1989). Also holds the direct irradiance from
 * the lamps.
 */
public final class MonteCarloFormFactors {
  /** The ray left the scene. */
  public static final int OUTSIDE = -1;

  /**
   * The ray does not count: it hit a surface from behind, so its start point lies inside of a
   * solid; or its start point is covered closely by another body, as behind a cupboard, while
   * others of the patch are open.
   */
  public static final int INSIDE = -2;

  /** Share of rays inside of solids above which a patch is buried. */
  static final double BURIED = 7.0 / 8;

  /**
   * Distance up to which another body covers a start point, as a share of the side of the patch.
   */
  private static final double CLOSE = 0.25;

  private final SurfacePatches patches;
  private final int[] first;
  private final int[] seen;
  private final float[] direct;
  private final long[] lampsOf;
  private final long cast;

  /**
   * The sampling effort.
   *
   * @param rays number of rays per patch
   * @param lampPlaces number of sample points per patch and lamp
   * @param fewer divisor of both numbers for patches of versions that are not the reference of
   *     their object, and so give no light to others: 1 for all, 4 for a quarter and so on
   */
  public record Effort(int rays, int lampPlaces, int fewer) {}

  private MonteCarloFormFactors(
      SurfacePatches patches, int[] first, int[] seen, float[] direct, long[] lampsOf, long cast) {
    this.patches = patches;
    this.first = first;
    this.seen = seen;
    this.direct = direct;
    this.lampsOf = lampsOf;
    this.cast = cast;
  }

  /** Samples the form factors with the same number of rays for all patches. */
  public static MonteCarloFormFactors find(
      RadiosityScene scene,
      SurfacePatches patches,
      int rays,
      int lampPlaces,
      int seed,
      RadiosityProgress progress) {
    return find(scene, patches, new Effort(rays, lampPlaces, 1), seed, progress);
  }

  /**
   * @return the form factors and the direct light; if cancelled, those found so far, and the rest
   *     dark
   */
  public static MonteCarloFormFactors find(
      RadiosityScene scene,
      SurfacePatches patches,
      Effort effort,
      int seed,
      RadiosityProgress progress) {
    int rays = effort.rays();
    int few = Math.max(1, rays / effort.fewer());
    int count = patches.count();
    int[] first = new int[count + 1];
    for (int patch = 0; patch < count; patch++) {
      boolean stands = scene.stands(patches.triangle(patch));
      first[patch + 1] = Math.addExact(first[patch], stands ? rays : few);
    }
    int[] seen = new int[first[count]];
    Arrays.fill(seen, INSIDE);
    float[] direct = new float[3 * count];
    long[] lampsOf = new long[count];
    CosineHemisphereSampler directions =
        new CosineHemisphereSampler(new SobolPointSet(rays, seed, 0));
    SobolPointSet places = new SobolPointSet(rays, seed, 1);
    SobolPointSet others = new SobolPointSet(rays, seed, 2);
    int fewPlaces = Math.max(1, effort.lampPlaces() / effort.fewer());
    LongAdder cast = new LongAdder();
    ParallelFor.run(
        count,
        256,
        progress,
        RadiosityProgress.Stage.TRANSPORT,
        (from, to) -> {
          Ray ray = new Ray();
          Caster caster = new Caster(scene, patches, ray);
          PatchDirectLightEstimator lamps = lamps(scene, patches, ray, effort.lampPlaces(), seed);
          PatchDirectLightEstimator fewLamps = lamps(scene, patches, ray, fewPlaces, seed);
          boolean[] covered = new boolean[rays];
          for (int patch = from; patch < to; patch++) {
            // Each patch has its own rotation of the sets, so that the errors of neighbours are not
            // correlated.
            float shift = (SobolPointSet.hash(patch + 31 * seed) >>> 8) * 0x1p-24f;
            int own = first[patch + 1] - first[patch];
            for (int i = 0; i < own; i++) {
              seen[first[patch] + i] = caster.see(patch, i, directions, places, others, shift);
              covered[i] = caster.covered();
            }
            leaveOut(covered, own, seen, first[patch]);
            PatchDirectLightEstimator light =
                scene.stands(patches.triangle(patch)) ? lamps : fewLamps;
            lampsOf[patch] = light.light(patch, shift, direct);
          }
          cast.add(ray.cast());
        });
    return new MonteCarloFormFactors(patches, first, seen, direct, lampsOf, cast.sum());
  }

  private static PatchDirectLightEstimator lamps(
      RadiosityScene scene, SurfacePatches patches, Ray ray, int places, int seed) {
    return new PatchDirectLightEstimator(
        scene,
        patches,
        ray,
        new SobolPointSet(places, seed, 4),
        new SobolPointSet(places, seed, 3));
  }

  /**
   * Leaves out covered rays, since light arrives at the open part of a patch only: the part behind
   * a cupboard must not darken the part that is visible beside it. Where hardly any ray is open,
   * all rays count.
   */
  private static void leaveOut(boolean[] covered, int rays, int[] seen, int first) {
    int closed = 0;
    for (int i = 0; i < rays; i++) {
      closed += covered[i] || seen[first + i] == INSIDE ? 1 : 0;
    }
    for (int i = 0; i < rays && closed <= BURIED * rays; i++) {
      seen[first + i] = covered[i] ? INSIDE : seen[first + i];
    }
  }

  /** Casts the rays of one thread. */
  private static final class Caster {
    private final RadiosityScene scene;
    private final SurfacePatches patches;
    private final SceneTriangles triangles;
    private final Ray ray;
    private final double[] point = new double[3];
    private final double[] normal = new double[3];
    private final double[] direction = new double[3];
    private boolean covered;

    Caster(RadiosityScene scene, SurfacePatches patches, Ray ray) {
      this.scene = scene;
      this.patches = patches;
      this.triangles = scene.triangles();
      this.ray = ray;
    }

    private int start(int patch, double pick, double s, double t) {
      int triangle = patches.place(patch, pick, s, t, point, normal);
      for (int axis = 0; axis < 3; axis++) {
        point[axis] += scene.offset() * normal[axis];
      }
      return triangle;
    }

    int see(
        int patch,
        int i,
        CosineHemisphereSampler directions,
        SobolPointSet places,
        SobolPointSet others,
        float shift) {
      int triangle =
          start(
              patch,
              SobolPointSet.turned(others.x(i), shift),
              SobolPointSet.turned(places.x(i), shift),
              places.y(i));
      covered = false;
      directions.about(normal, i, direction);
      ray.from(point, direction);
      ray.length = Double.POSITIVE_INFINITY;
      ray.pass = SobolPointSet.turned(others.y(i), shift);
      scene.visibility().nearest(ray, triangles.version()[triangle]);
      if (ray.triangle == Ray.NOTHING) {
        return OUTSIDE;
      }
      if (ray.behind && !triangles.twoSided()[ray.triangle]) {
        return INSIDE;
      }
      int met = patches.at(ray.triangle, ray.u, ray.v, ray.behind);
      double close = CLOSE * Math.sqrt(patches.area(patch));
      covered = ray.length < close && other(triangle) && facesOther(triangle, close);
      return met;
    }

    /** Returns whether the start point of the last ray is covered closely by another body. */
    boolean covered() {
      return covered;
    }

    private boolean other(int triangle) {
      return scene.bodyOf()[ray.triangle] != scene.bodyOf()[triangle];
    }

    private boolean facesOther(int triangle, double close) {
      ray.from(point, normal);
      ray.length = close;
      scene.visibility().nearest(ray, triangles.version()[triangle]);
      return ray.triangle != Ray.NOTHING && other(triangle);
    }
  }

  public SurfacePatches patches() {
    return patches;
  }

  /** Returns the number of a patch's rays. */
  public int rays(int patch) {
    return first[patch + 1] - first[patch];
  }

  /** Returns the patch that the i-th ray of a patch hit, {@link #OUTSIDE} or {@link #INSIDE}. */
  public int seen(int patch, int i) {
    return seen[first[patch] + i];
  }

  /** Returns the direct irradiance from the lamps, r, g, b of each patch, lx. */
  public float[] direct() {
    return direct;
  }

  /** Returns per patch, bit i: whether some part of lamp i is visible from it. */
  public long[] lampsOf() {
    return lampsOf;
  }

  /** Returns the form factor: the share of the light leaving one patch that arrives at another. */
  public double formFactor(int patch, int other) {
    int met = 0;
    for (int i = 0; i < rays(patch); i++) {
      met += seen(patch, i) == other ? 1 : 0;
    }
    return (double) met / rays(patch);
  }

  /** Returns the number of rays cast. */
  public long cast() {
    return cast;
  }
}
