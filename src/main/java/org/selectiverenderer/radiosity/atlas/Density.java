package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;

/**
 * How fine bodies are stored: a room's surfaces coarsely, what lies on tables finely, since the
 * shadow that a thing casts on itself and beside it is as small as the thing. Scenes much larger or
 * smaller than a dwelling are stored as if they were one.
 */
final class Density {
  /** Of surfaces as large as a room's, texels per metre. */
  private static final double ROOM = 40;

  /** As large as a room is, metres. */
  private static final double ROOM_SIZE = 4;

  private static final double GROWTH = 0.4;
  private static final double LEAST = 0.8;
  private static final double MOST = 3;

  /**
   * Versions that take their light from another have more texels: they cost no rays, and light that
   * changes from one texel of the other to the next is not blurred by being read from between.
   * Large things have no such light, and would have too many texels.
   */
  private static final double SHARING = 2;

  /** Things of this size have no more texels for that, metres. */
  private static final double SHARING_SIZE = 1;

  /** Scenes of this extent have rooms of that size, metres. */
  private static final double LARGE_SCENE = 60;

  private static final double SMALL_SCENE = 1;

  /** So many times as fine a body can be by a wish: 64 times the texels take their time. */
  private static final double FINER = 8;

  private Density() {}

  /** Texels per metre for each body before any budget. */
  static double[] of(LightScene scene, AtlasSettings settings) {
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
   * The same, finer where that was wished for and is not too much finer.
   *
   * @param wished texels by body, 0 for none
   * @return empty if it is nowhere finer
   */
  static Optional<double[]> finer(
      double[] densities,
      double[] wished,
      @Nullable BodyCharts[] charts,
      TexelBoxes boxes,
      PagePlanner planner) {
    double[] finer = densities.clone();
    for (int i = 0; i < finer.length; i++) {
      BodyCharts own = charts[i];
      double density = own == null || wished[i] <= 0 ? 0 : Math.sqrt(wished[i] / own.area());
      if (density > finer[i]
          && density <= FINER * finer[i]
          && planner.fits(i, boxes.size(i, density))) {
        finer[i] = density;
      }
    }
    return Arrays.equals(finer, densities) ? Optional.empty() : Optional.of(finer);
  }

  /** The longest side of the box around a body, metres. */
  private static double size(LightScene scene, Body body) {
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
