package org.selectiverenderer.browser.nodes.group;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Billboard: turns its children's +Z axis towards the viewer, about an axis or freely (X3D 4.0,
 * 23.4.1).
 */
public final class BillboardNode extends GroupingNode implements ViewerDependentNode {
  private final int axisOfRotation;
  private final Matrix4d placement = new Matrix4d();

  public BillboardNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    axisOfRotation = type.indexOf("axisOfRotation");
  }

  @Override
  public Optional<Matrix4d> placement() {
    return Optional.of(new Matrix4d(placement));
  }

  @Override
  public Effect view(Vector3dc viewer, Vector3dc up, EventCascade cascade) {
    float[] a = (float[]) value(axisOfRotation);
    Vector3d axis = new Vector3d(a[0], a[1], a[2]);
    Matrix4d next =
        axis.lengthSquared() == 0 ? facing(viewer, up) : turned(axis.normalize(), viewer);
    if (next.equals(placement, 1e-9)) {
      return Effect.NONE;
    }
    placement.set(next);
    return Effect.PLACEMENT;
  }

  /**
   * Returns the rotation about an axis that turns +Z towards the viewer's direction, projected onto
   * the plane normal to the axis.
   */
  private static Matrix4d turned(Vector3d axis, Vector3dc viewer) {
    Vector3d to = new Vector3d(viewer).fma(-axis.dot(viewer), axis);
    Vector3d front = new Vector3d(0, 0, 1).fma(-axis.z, axis);
    if (to.lengthSquared() < 1e-18 || front.lengthSquared() < 1e-18) {
      return new Matrix4d();
    }
    double angle = Math.atan2(front.cross(to, new Vector3d()).dot(axis), front.dot(to));
    return new Matrix4d().rotate(angle, axis);
  }

  /** Returns the free rotation: +Z to the viewer, +Y as near to the viewer's up as that allows. */
  private static Matrix4d facing(Vector3dc viewer, Vector3dc up) {
    Vector3d z = new Vector3d(viewer).normalize();
    Vector3d x = up.cross(z, new Vector3d()).normalize();
    Vector3d y = z.cross(x, new Vector3d());
    Matrix4d facing =
        new Matrix4d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1);
    return facing.isFinite() ? facing : new Matrix4d();
  }
}
