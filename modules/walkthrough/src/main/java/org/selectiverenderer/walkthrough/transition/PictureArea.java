package org.selectiverenderer.walkthrough.transition;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector4d;
import org.selectiverenderer.browser.camera.Camera;

/**
 * A rectangle of the picture; the whole picture is -1..1 in both directions.
 *
 * @param left at most {@code right}
 * @param bottom at most {@code top}
 */
record PictureArea(double left, double bottom, double right, double top) {
  /** The corners at the ends of a box's edges. A corner's bits tell its sides in x, y and z. */
  private static final int[][] EDGES = {
    {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}
  };

  /**
   * Returns the smallest area that covers boxes as far as they lie before the near plane; empty if
   * they are out of the view.
   *
   * @param boxes in the world: min x, y, z, max x, y, z
   * @param toClip the matrix from world to clip coordinates
   */
  static Optional<PictureArea> of(List<double[]> boxes, Matrix4dc toClip) {
    double[] all = {1, 1, -1, -1};
    boolean any = false;
    for (double[] box : boxes) {
      double[] own = projected(box, toClip);
      own =
          new double[] {
            Math.max(-1, own[0]), Math.max(-1, own[1]), Math.min(1, own[2]), Math.min(1, own[3])
          };
      if (own[0] <= own[2] && own[1] <= own[3]) {
        any = true;
        all[0] = Math.min(all[0], own[0]);
        all[1] = Math.min(all[1], own[1]);
        all[2] = Math.max(all[2], own[2]);
        all[3] = Math.max(all[3], own[3]);
      }
    }
    return any ? Optional.of(new PictureArea(all[0], all[1], all[2], all[3])) : Optional.empty();
  }

  /** Returns the bounds in the picture's plane; the least above the most if there are none. */
  private static double[] projected(double[] box, Matrix4dc toClip) {
    double most = Double.POSITIVE_INFINITY;
    double[] bounds = {most, most, -most, -most};
    if (box[0] > box[3]) {
      return bounds;
    }
    Vector4d[] corners = new Vector4d[8];
    for (int corner = 0; corner < 8; corner++) {
      corners[corner] =
          new Vector4d(
                  box[(corner & 1) == 0 ? 0 : 3],
                  box[(corner & 2) == 0 ? 1 : 4],
                  box[(corner & 4) == 0 ? 2 : 5],
                  1)
              .mul(toClip);
      if (before(corners[corner]) >= 0) {
        extend(bounds, corners[corner]);
      }
    }
    for (int[] edge : EDGES) {
      Vector4d from = corners[edge[0]];
      Vector4d to = corners[edge[1]];
      double first = before(from);
      double second = before(to);
      if (first < 0 != second < 0) {
        extend(bounds, from.lerp(to, first / (first - second), new Vector4d()));
      }
    }
    return bounds;
  }

  /** Returns how far a point in clip coordinates lies before the near plane; negative if behind. */
  private static double before(Vector4d clip) {
    return clip.z + clip.w;
  }

  private static void extend(double[] bounds, Vector4d clip) {
    if (clip.w > 0) {
      bounds[0] = Math.min(bounds[0], clip.x / clip.w);
      bounds[1] = Math.min(bounds[1], clip.y / clip.w);
      bounds[2] = Math.max(bounds[2], clip.x / clip.w);
      bounds[3] = Math.max(bounds[3], clip.y / clip.w);
    }
  }

  /** Returns the number of pixels of an eye's picture in the area. */
  double pixels(Camera eye) {
    return (right - left) / 2 * eye.width() * (top - bottom) / 2 * eye.height();
  }
}
