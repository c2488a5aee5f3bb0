package org.selectiverenderer.models.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The joints of a mesh and the pose in which it was bound to them. A vertex {@code v} is shown at
 * the sum over its joints of {@code weight · place · inverse · v}, where {@code place} is the
 * joint's matrix in the scene and {@code inverse} that of its pose when it was bound (glTF 2.0,
 * 3.7.3). The figure that it becomes stands where the skin is at rest, so that what knows no joints
 * finds it there too.
 */
public final class Skin {
  private static final double NEAR = 1e-3;

  /** A position, a rotation and a scale along all axes. */
  private record Pose(Vector3d position, Quaterniond rotation, double scale) {
    static final Pose NONE = new Pose(new Vector3d(), new Quaterniond(), 1);
  }

  private final List<ModelNode> nodes;
  private final int[] joints;
  private final Map<Integer, Pose> bound = new HashMap<>();
  private final Matrix4d toRest;
  private boolean exact = true;

  /**
   * Creates a skin.
   *
   * @param nodes all nodes of the model, a tree
   * @param joints the indices of the nodes that are joints
   * @param inverses for each joint the matrix from the mesh's coordinates to the joint's when it
   *     was bound, 16 numbers in column-major order
   */
  public Skin(List<ModelNode> nodes, int[] joints, List<double[]> inverses) {
    this.nodes = nodes;
    this.joints = joints.clone();
    toRest = joints.length == 0 ? new Matrix4d() : rest(joints[0], inverses.get(0));
    for (int i = 0; i < joints.length; i++) {
      Matrix4d inverse = new Matrix4d().set(inverses.get(i));
      boolean invertible = Math.abs(inverse.determinant()) > 0 && inverse.isFinite();
      exact &= invertible;
      bound.put(
          joints[i], invertible ? pose(new Matrix4d(toRest).mul(inverse.invert())) : Pose.NONE);
    }
  }

  /** Returns the matrix from the mesh's coordinates to those of the figure, which is no mirror. */
  private Matrix4d rest(int joint, double[] inverse) {
    Matrix4d rest = new Matrix4d().set(inverse);
    for (int node = joint; node >= 0; node = nodes.get(node).parent()) {
      rest = nodes.get(node).place().matrix().mul(rest);
    }
    boolean usable = rest.isFinite() && rest.determinant() > 0;
    return usable && isSimilarity(NodeTransform.of(rest.get(new double[16])))
        ? rest
        : new Matrix4d();
  }

  private static boolean isSimilarity(NodeTransform transform) {
    double[] s = transform.scale();
    return !transform.sheared()
        && s[0] > 0
        && Math.abs(s[1] / s[0] - 1) < NEAR
        && Math.abs(s[2] / s[0] - 1) < NEAR;
  }

  private Pose pose(Matrix4d matrix) {
    NodeTransform placed = NodeTransform.of(matrix.get(new double[16]));
    exact &= isSimilarity(placed);
    double[] t = placed.translation();
    double[] r = placed.rotation();
    double[] s = placed.scale();
    double scale = Math.cbrt(Math.abs(s[0] * s[1] * s[2]));
    boolean usable = Double.isFinite(scale) && scale > 0;
    return new Pose(
        new Vector3d(t[0], t[1], t[2]),
        new Quaterniond(r[0], r[1], r[2], r[3]),
        usable ? scale : 1);
  }

  /**
   * Returns whether X3D's joints can express the skin: false where the pose in which it was bound
   * is sheared, mirrored or scaled differently along its axes.
   */
  public boolean isExact() {
    return exact;
  }

  /** Returns the number of joints. */
  public int size() {
    return joints.length;
  }

  /**
   * Returns whether a joint is nested deeper in the tree of nodes than a number of levels. No more
   * levels than these are walked up, so that the time does not grow with the depth of the tree.
   */
  public boolean isDeeperThan(int levels) {
    for (int joint : joints) {
      int depth = 0;
      for (int node = joint; node >= 0; node = nodes.get(node).parent()) {
        if (++depth > levels) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns the index of the node of a joint. */
  int node(int joint) {
    return joints[joint];
  }

  List<ModelNode> nodes() {
    return nodes;
  }

  /** Returns points, or normals, in the coordinates of the figure. */
  public float[] atRest(float[] xyz, boolean normals) {
    float[] moved = new float[xyz.length];
    Vector3d at = new Vector3d();
    for (int i = 0; i + 2 < xyz.length; i += 3) {
      at.set(xyz[i], xyz[i + 1], xyz[i + 2]);
      if (normals) {
        toRest.transformDirection(at);
        double length = at.length();
        at.div(length > 0 ? length : 1);
      } else {
        toRest.transformPosition(at);
      }
      moved[i] = (float) at.x;
      moved[i + 1] = (float) at.y;
      moved[i + 2] = (float) at.z;
    }
    return moved;
  }

  /** Returns the nodes of some joints and all nodes above them, parents first. */
  List<Integer> closure(List<Integer> used) {
    Set<Integer> all = new LinkedHashSet<>();
    for (int joint : used) {
      List<Integer> path = new ArrayList<>();
      for (int node = joints[joint];
          node >= 0 && !all.contains(node);
          node = nodes.get(node).parent()) {
        path.add(0, node);
      }
      all.addAll(path);
    }
    return List.copyOf(all);
  }

  JointBinding binding(int node) {
    Pose parent = bound.getOrDefault(nodes.get(node).parent(), Pose.NONE);
    Pose own = bound.getOrDefault(node, Pose.NONE);
    return new JointBinding(
        parent.position(),
        parent.rotation(),
        parent.scale(),
        own.position(),
        own.rotation(),
        own.scale());
  }
}
