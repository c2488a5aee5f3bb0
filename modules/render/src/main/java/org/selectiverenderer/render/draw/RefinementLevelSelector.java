package org.selectiverenderer.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.lighting.CurvatureTolerance;
import org.selectiverenderer.render.mesh.RefinementLevelRange;
import org.selectiverenderer.render.mesh.TriangleClusters;

/**
 * Selects the refinement level at which a mesh refined for per-vertex lighting is drawn: the
 * coarsest level in which no edge that finer levels split is long on the screen of any eye. All
 * levels have the same surface, so that only the lighting differs, and that within a few pixels.
 * Depends on the eyes and the shape alone, not on earlier frames.
 */
final class RefinementLevelSelector {
  /**
   * The pixels between two vertices within which interpolated light is not told from per-pixel
   * light: with 16, pictures differ from those with per-pixel lighting as little as without coarser
   * levels; with 32, highlights become duller.
   */
  private static final double MOST_PIXELS = 16;

  private List<Camera> eyes = List.of();

  /** Begins a frame with its eyes. */
  void begin(List<Camera> seeing) {
    eyes = seeing;
  }

  /** Returns the clusters to draw of an item. */
  TriangleClusters of(DrawItem item) {
    List<RefinementLevelRange> coarser = item.part().coarser();
    return coarser.isEmpty() || item.anywhere()
        ? item.clusters()
        : of(
            item.clusters(),
            coarser,
            item.shape().bounds(),
            CurvatureTolerance.scale(item.place()));
  }

  /**
   * Selects one of several levels.
   *
   * @param last the finest level
   * @param coarser the other levels, fewest triangles first
   * @param box the bounding box in the world
   * @param scale the scale from the levels' lengths to the world's
   */
  TriangleClusters of(
      TriangleClusters last, List<RefinementLevelRange> coarser, double[] box, double scale) {
    double most = MOST_PIXELS / (pixels(box) * scale);
    for (int i = 0; i < coarser.size(); i++) {
      if (coarser.get(i).undivided() <= most) {
        return coarser.get(i).clusters();
      }
    }
    return last;
  }

  /** Returns the most pixels that a unit of length has in the nearest part of a box. */
  private double pixels(double[] box) {
    double most = 0;
    for (int i = 0; i < eyes.size(); i++) {
      Camera eye = eyes.get(i);
      double unit =
          Math.max(
              Math.abs(eye.projection().m00()) * eye.width() / 2,
              Math.abs(eye.projection().m11()) * eye.height() / 2);
      most = Math.max(most, eye.parallel() ? unit : unit / Math.max(0, depth(eye.view(), box)));
    }
    return most;
  }

  /** Returns the depth of the nearest corner of a box before the eye; below 0 behind it. */
  private static double depth(Matrix4dc view, double[] box) {
    return -view.m32()
        - view.m02() * box[view.m02() > 0 ? 3 : 0]
        - view.m12() * box[view.m12() > 0 ? 4 : 1]
        - view.m22() * box[view.m22() > 0 ? 5 : 2];
  }
}
