package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.render.light.Fineness;
import org.selectiverenderer.runtime.render.mesh.Clusters;
import org.selectiverenderer.runtime.render.mesh.CoarserPart;

/**
 * Chooses which stage of a mesh that was divided for its light is drawn: the one with the fewest
 * triangles of which no edge that later stages divide is long in the picture of any eye. All stages
 * have the same surface, so that nothing but light differs, and that within a few pixels. Depends
 * on nothing but the eyes and the shape: what was drawn before does not matter.
 */
final class Stages {
  /**
   * Pixels within which nobody sees how light goes on between two vertices: with 16, pictures
   * differ from those by pixel as they do without stages; with 32, highlights become duller.
   */
  private static final double MOST_PIXELS = 16;

  private List<Camera> eyes = List.of();

  /** Begins with what some eyes see. */
  void begin(List<Camera> seeing) {
    eyes = seeing;
  }

  /** The triangles to draw of an item. */
  Clusters of(DrawItem item) {
    List<CoarserPart> coarser = item.part().coarser();
    return coarser.isEmpty() || item.anywhere()
        ? item.clusters()
        : of(item.clusters(), coarser, item.shape().bounds(), Fineness.scale(item.place()));
  }

  /**
   * One of several stages.
   *
   * @param last that of the most triangles
   * @param coarser the others, fewest triangles first
   * @param box around them in the world
   * @param scale of the world's lengths to those of the stages
   */
  Clusters of(Clusters last, List<CoarserPart> coarser, double[] box, double scale) {
    double most = MOST_PIXELS / (pixels(box) * scale);
    for (int i = 0; i < coarser.size(); i++) {
      if (coarser.get(i).undivided() <= most) {
        return coarser.get(i).clusters();
      }
    }
    return last;
  }

  /** How many pixels a unit of the world has in the nearest part of a box, at most. */
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

  /** How far before the eye the nearest part of a box is; below 0 behind it. */
  private static double depth(Matrix4dc view, double[] box) {
    return -view.m32()
        - view.m02() * box[view.m02() > 0 ? 3 : 0]
        - view.m12() * box[view.m12() > 0 ? 4 : 1]
        - view.m22() * box[view.m22() > 0 ? 5 : 2];
  }
}
