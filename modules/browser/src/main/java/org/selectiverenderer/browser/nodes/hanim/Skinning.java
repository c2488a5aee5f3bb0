package org.selectiverenderer.browser.nodes.hanim;

import java.util.List;
import org.joml.Matrix3d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.browser.nodes.group.TransformNode;

/**
 * Linear blend skinning (ISO/IEC 19774-1, 4.9; X3D 4.0, 26.2.4): each skin point is the mean of its
 * positions under the joints that name it, weighted by their {@code skinCoordWeight}. In the rest
 * pose no joint is rotated. Points that no joint names stay in place.
 */
final class Skinning {
  private Skinning() {}

  /**
   * @param joints the joints
   * @param placements the joints' present matrices to the humanoid's coordinates
   * @param rest the points or normals of the rest pose, as x, y, z
   * @param vectors whether these are normals, which are rotated but not translated
   */
  static float[] of(
      List<TransformNode> joints, Matrix4dc[] placements, float[] rest, boolean vectors) {
    int count = rest.length / 3;
    double[] sums = new double[rest.length];
    double[] weights = new double[count];
    Vector3d at = new Vector3d();
    for (int j = 0; j < placements.length; j++) {
      int[] index = joints.get(j).ints("skinCoordIndex");
      float[] weight = joints.get(j).floats("skinCoordWeight");
      Matrix3d turn = vectors ? placements[j].normal(new Matrix3d()) : new Matrix3d();
      for (int i = 0; i < index.length; i++) {
        int p = index[i];
        // A missing weight counts as 1, as in humanoids with one joint per point.
        double w = i < weight.length ? weight[i] : 1;
        if (p < 0 || p >= count || !(w != 0) || !Double.isFinite(w)) {
          continue;
        }
        at.set(rest[3 * p], rest[3 * p + 1], rest[3 * p + 2]);
        if (vectors) {
          turn.transform(at);
        } else {
          placements[j].transformPosition(at);
        }
        sums[3 * p] += w * at.x;
        sums[3 * p + 1] += w * at.y;
        sums[3 * p + 2] += w * at.z;
        weights[p] += w;
      }
    }
    float[] moved = rest.clone();
    for (int p = 0; p < count; p++) {
      double by = vectors ? length(sums, 3 * p) : weights[p];
      if (Math.abs(by) > 1e-9) {
        for (int i = 3 * p; i < 3 * p + 3; i++) {
          moved[i] = (float) (sums[i] / by);
        }
      }
    }
    return moved;
  }

  private static double length(double[] xyz, int at) {
    return Vector3d.length(xyz[at], xyz[at + 1], xyz[at + 2]);
  }
}
