package org.selectiverenderer.browser.nodes.drag;

import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Converts dragging to a rotation of a sphere (X3D 4.0, 20.4.3). The sphere has its centre at the
 * origin of the local coordinates and contains the point at which the drag begins. The rotation is
 * {@code offset} followed by the one that moves that point to the pointer. If the ray misses the
 * sphere, the sphere's nearest point counts.
 */
final class SphereSensorNode extends DragSensorNode {
  private static final Vector3dc ALL_AXES = new Vector3d(1);

  SphereSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location, "rotation_changed");
  }

  @Override
  DragSurface surface(Vector3dc hit, DragRay ray) {
    double radius = hit.length();
    boolean far = DragSurfaceSide.far(ray, hit, radius, ALL_AXES);
    Vector3d start = onSphere(ray, radius, far);
    float[] begin = (float[]) offset();
    Quaterniond offset = Rotations.read(begin, 0, new Quaterniond());
    return new DragSurface() {
      private float[] last = begin;

      @Override
      public Optional<Vector3d> follow(DragRay to) {
        return Optional.of(onSphere(to, radius, far));
      }

      @Override
      public Object value(Vector3dc point) {
        Quaterniond way = new Quaterniond().rotationTo(start, point).mul(offset);
        last = new float[4];
        Rotations.write(way, last);
        return last;
      }

      @Override
      public Object offset() {
        return last;
      }
    };
  }

  private static Vector3d onSphere(DragRay ray, double radius, boolean far) {
    Vector3d point = ray.atRadius(radius, ALL_AXES, far);
    double length = point.length();
    return length > 0 ? point.mul(radius / length) : point;
  }
}
