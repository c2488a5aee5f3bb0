package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Chooses the texel density of each body: coarse for a room's surfaces and fine for small objects,
 * since the shadows that an object casts on itself and beside it are as small as the object. Scenes
 * much larger or smaller than a dwelling are scaled to the size of one.
 */
final class TexelDensity {
  /** Density of surfaces as large as a room's, texels per metre. */
  private static final double ROOM = 40;

  /** Size of a room, metres. */
  private static final double ROOM_SIZE = 4;

  private static final double GROWTH = 0.4;
  private static final double LEAST = 0.8;
  private static final double MOST = 3;

  /**
   * Factor of the density of versions that copy their light from the reference version: their
   * texels cost no rays, and at a higher density the copy does not blur light that changes from one
   * texel of the reference version to the next. Large objects have no such fine light and would
   * have too many texels.
   */
  private static final double SHARING = 2;

  /** Size of an object from which on that factor is 1, metres. */
  private static final double SHARING_SIZE = 1;

  /** Largest and smallest extent of a scene whose rooms have that size, metres. */
  private static final double LARGE_SCENE = 60;

  private static final double SMALL_SCENE = 1;

  /**
   * Largest factor of the density for a body's own texture: 64 times the texels take their time.
   */
  private static final double FINER = 8;

  private TexelDensity() {}

  /** Returns the texels per metre of each body before the budget is applied. */
  static double[] of(RadiosityScene scene, AtlasSettings settings) {
    double room = ROOM_SIZE;
    if (scene.extent() > LARGE_SCENE) {
      room *= scene.extent() / LARGE_SCENE;
    } else if (scene.extent() > 0 && scene.extent() < SMALL_SCENE) {
      room *= scene.extent() / SMALL_SCENE;
    }
    double base = settings.texelsPerMetre().orElse(ROOM * ROOM_SIZE / room);
    double[] densities = new double[scene.bodies().size()];
    for (int i = 0; i < densities.length; i++) {
      double size = size(scene, scene.bodies().get(i));
      double finer = size > 0 ? StrictMath.pow(room / size, GROWTH) : MOST;
      densities[i] = base * Math.max(LEAST, Math.min(MOST, finer));
      if (size > 0 && !scene.stands(scene.bodies().get(i).firstTriangle())) {
        densities[i] *= Math.max(1, Math.min(SHARING, SHARING_SIZE * room / ROOM_SIZE / size));
      }
    }
    return densities;
  }

  /**
   * Returns the densities, raised for bodies whose own texture needs more texels, if the factor is
   * not too large.
   *
   * @param wished by body: number of texels that its texture needs, 0 for none
   * @return empty if no density is raised
   */
  static Optional<double[]> finer(
      double[] densities,
      double[] wished,
      @Nullable UvCharts[] charts,
      ChartRectangles boxes,
      AtlasPacker planner) {
    double[] finer = densities.clone();
    for (int i = 0; i < finer.length; i++) {
      UvCharts own = charts[i];
      double density = own == null || wished[i] <= 0 ? 0 : Math.sqrt(wished[i] / own.area());
      if (density > finer[i]
          && density <= FINER * finer[i]
          && planner.fits(i, boxes.size(i, density))) {
        finer[i] = density;
      }
    }
    return Arrays.equals(finer, densities) ? Optional.empty() : Optional.of(finer);
  }

  /** Returns the longest side of a body's bounding box, metres. */
  private static double size(RadiosityScene scene, Body body) {
    float[] corners = scene.triangles().corners();
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
      float low = Float.POSITIVE_INFINITY;
      float high = Float.NEGATIVE_INFINITY;
      int end = 9 * (body.firstTriangle() + body.triangles());
      for (int i = 9 * body.firstTriangle() + axis; i < end; i += 3) {
        low = Math.min(low, corners[i]);
        high = Math.max(high, corners[i]);
      }
      size = Math.max(size, (double) high - low);
    }
    return size;
  }
}
