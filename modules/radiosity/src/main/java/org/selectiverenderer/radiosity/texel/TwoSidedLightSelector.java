package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.atlas.OrientedComponentFinder;
import org.selectiverenderer.radiosity.sampling.CosineHemisphereSampler;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Selects the lit side of each two-sided surface: a lightmap and a vertex store one light for both
 * sides. The choice is made once for a whole sheet, since otherwise the inside of a bin would show
 * in spots on its outside. The side with the larger product of light and free space in front of it
 * is chosen: the outside of a bin is visible from far more places than its inside, and a side that
 * is dark or lies against a wall is not seen. Immutable.
 */
public final class TwoSidedLightSelector {
  /**
   * Number of sample points on a sheet, and of rays from each to either side, that measure its free
   * space.
   */
  private static final int PLACES = 64;

  private static final int RAYS = 4;

  private final boolean[] behind;

  private TwoSidedLightSelector(boolean[] behind) {
    this.behind = behind;
  }

  /**
   * Selects the lit sides of all bodies of a scene.
   *
   * @param solution the radiosity solution of the scene
   */
  public static TwoSidedLightSelector of(
      RadiosityScene scene, RadiositySolution solution, int seed) {
    boolean[] behind = new boolean[scene.triangles().count()];
    CosineHemisphereSampler directions =
        new CosineHemisphereSampler(new SobolPointSet(PLACES * RAYS, seed, 24));
    IntStream.range(0, scene.bodies().size())
        .parallel()
        .mapToObj(scene.bodies()::get)
        .filter(body -> body.triangles() > 0)
        .filter(body -> scene.triangles().twoSided()[body.firstTriangle()])
        .forEach(body -> new Look(scene, solution, body, directions).into(behind));
    return new TwoSidedLightSelector(behind);
  }

  /**
   * Returns whether the back of a triangle is its lit side; false for one-sided triangles.
   *
   * @param triangle number of the triangle in the scene
   */
  public boolean behind(int triangle) {
    return behind[triangle];
  }

  /** Measures light and free space on both sides of one body's sheets; for one thread. */
  private static final class Look {
    private final RadiosityScene scene;
    private final RadiositySolution solution;
    private final Body body;
    private final CosineHemisphereSampler directions;
    private final int[] sheets;
    private final int count;
    private final double[] areas;

    // Per sheet, front and back: sums of the light and of the lengths of rays over its sample
    // points.
    private final double[] light;
    private final double[] space;

    private final Ray ray = new Ray();
    private final double[] point = new double[3];
    private final double[] start = new double[3];
    private final double[] normal = new double[3];
    private final double[] direction = new double[3];

    Look(
        RadiosityScene scene,
        RadiositySolution solution,
        Body body,
        CosineHemisphereSampler directions) {
      this.scene = scene;
      this.solution = solution;
      this.body = body;
      this.directions = directions;
      sheets = OrientedComponentFinder.of(scene, body);
      count = Arrays.stream(sheets).max().orElse(-1) + 1;
      areas = new double[count];
      light = new double[2 * count];
      space = new double[2 * count];
    }

    void into(boolean[] behind) {
      for (int i = 0; i < sheets.length; i++) {
        areas[sheets[i]] += scene.triangles().normal(body.firstTriangle() + i, normal);
      }
      look();
      for (int i = 0; i < sheets.length; i++) {
        int at = 2 * sheets[i];
        behind[body.firstTriangle() + i] = light[at + 1] * space[at + 1] > light[at] * space[at];
      }
    }

    /** Samples points that are distributed evenly over each sheet. */
    private void look() {
      double[] passed = new double[count];
      int[] places = new int[count];
      double extent = extent();
      for (int i = 0; i < sheets.length; i++) {
        int sheet = sheets[i];
        int triangle = body.firstTriangle() + i;
        double area = scene.triangles().normal(triangle, normal);
        passed[sheet] += area;
        while (area > 0
            && places[sheet] < PLACES
            && passed[sheet] * PLACES >= (places[sheet] + 0.5) * areas[sheet]) {
          look(triangle, sheet, places[sheet]++, extent);
        }
      }
    }

    private void look(int triangle, int sheet, int place, double extent) {
      // A low-discrepancy sequence over the triangle (Roberts 2018, "R2").
      double u = place * 0.7548776662466927 % 1;
      double v = place * 0.5698402909980532 % 1;
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      scene.triangles().point(triangle, u, v, point);
      for (int side = 0; side < 2; side++) {
        light[2 * sheet + side] += arriving(solution.patches().at(triangle, u, v, side == 1));
        scene.triangles().normal(triangle, normal);
        for (int axis = 0; axis < 3; axis++) {
          normal[axis] *= side == 0 ? 1 : -1;
          start[axis] = point[axis] + scene.offset() * normal[axis];
        }
        for (int k = 0; k < RAYS; k++) {
          space[2 * sheet + side] += free(RAYS * place + k, extent);
        }
      }
    }

    private double arriving(int patch) {
      double sum = 0;
      for (int i = 3 * patch; i < 3 * patch + 3 && !solution.buried()[patch]; i++) {
        sum += solution.direct()[i] + solution.indirect()[i];
      }
      return sum;
    }

    /**
     * Casts one ray and returns its length; a ray that hits nothing counts as long as the body,
     * since no viewer is out there.
     */
    private double free(int turn, double extent) {
      directions.about(normal, turn, direction);
      ray.from(start, direction);
      ray.length = Double.POSITIVE_INFINITY;
      ray.pass = 0.5;
      scene.visibility().nearest(ray, body.version());
      if (ray.triangle == Ray.NOTHING) {
        return extent;
      }
      return ray.behind && !scene.triangles().twoSided()[ray.triangle] ? 0 : ray.length;
    }

    private double extent() {
      double square = 0;
      for (int axis = 0; axis < 3; axis++) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = axis; i < body.positions().length; i += 3) {
          least = Math.min(least, body.positions()[i]);
          most = Math.max(most, body.positions()[i]);
        }
        square += (most - least) * (most - least);
      }
      return Math.sqrt(square);
    }
  }
}
