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
 * Converts dragging to a rotation about an axis (X3D 4.0, 20.4.1), the Y axis of the coordinates
 * rotated by {@code axisRotation}. If the angle between pointer ray and axis is below {@code
 * diskAngle} when the drag begins, the pointer is followed on a disk: the plane normal to the axis
 * through the starting point. Otherwise it is followed on the cylinder through that point; where
 * the ray misses the cylinder, by the ray's nearest point to the axis. The angle accumulates beyond
 * half a turn. {@code minAngle} and {@code maxAngle} limit it unless the minimum is above the
 * maximum.
 */
final class CylinderSensorNode extends DragSensorNode {
  private static final Vector3dc ACROSS = new Vector3d(1, 0, 1);
  private static final Vector3dc AXIS = new Vector3d(0, 1, 0);

  private final int axisRotation;
  private final int diskAngle;
  private final int minAngle;
  private final int maxAngle;

  CylinderSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location, "rotation_changed");
    axisRotation = type.indexOf("axisRotation");
    diskAngle = type.indexOf("diskAngle");
    minAngle = type.indexOf("minAngle");
    maxAngle = type.indexOf("maxAngle");
  }

  @Override
  DragSurface surface(Vector3dc hit, DragRay ray) {
    Quaterniond turned = Rotations.read((float[]) value(axisRotation), 0, new Quaterniond());
    DragRay begin = turnedBack(turned, ray);
    Vector3d start = turned.transformInverse(hit, new Vector3d());
    double slant = begin.direction().angle(AXIS);
    boolean disk = Math.min(slant, Math.PI - slant) < (Float) value(diskAngle);
    double radius = Math.hypot(start.x, start.z);
    boolean far = !disk && DragSurfaceSide.far(begin, start, radius, ACROSS);
    return new Turn(turned, start, disk, radius, far, (Float) offset());
  }

  private static DragRay turnedBack(Quaterniond turned, DragRay ray) {
    return new DragRay(
        turned.transformInverse(ray.origin(), new Vector3d()),
        turned.transformInverse(ray.direction(), new Vector3d()));
  }

  private double limited(double angle) {
    double min = (Float) value(minAngle);
    double max = (Float) value(maxAngle);
    return min <= max ? Math.max(min, Math.min(max, angle)) : angle;
  }

  /** The surface of one drag. */
  private final class Turn implements DragSurface {
    private final Quaterniond turned;
    private final Vector3dc start;
    private final boolean disk;
    private final double radius;
    private final boolean far;
    private double heading;
    private double angle;
    private float last;

    Turn(
        Quaterniond turned,
        Vector3dc start,
        boolean disk,
        double radius,
        boolean far,
        float offset) {
      this.turned = turned;
      this.start = start;
      this.disk = disk;
      this.radius = radius;
      this.far = far;
      heading = heading(start);
      angle = offset;
      last = offset;
    }

    @Override
    public Optional<Vector3d> follow(DragRay to) {
      DragRay ray = turnedBack(turned, to);
      Optional<Vector3d> point =
          disk ? ray.onPlane(start, AXIS) : Optional.of(ray.atRadius(radius, ACROSS, far));
      return point.map(turned::transform);
    }

    @Override
    public Object value(Vector3dc point) {
      double now = heading(turned.transformInverse(point, new Vector3d()));
      angle += Math.IEEEremainder(now - heading, 2 * Math.PI);
      heading = now;
      last = (float) limited(angle);
      Vector3d axis = turned.transform(AXIS, new Vector3d());
      return new float[] {(float) axis.x, (float) axis.y, (float) axis.z, last};
    }

    @Override
    public Object offset() {
      return last;
    }
  }

  /** Returns the angle about Y, from Z towards X; it is undefined for a point on the axis. */
  private static double heading(Vector3dc point) {
    return Math.atan2(point.x(), point.z());
  }
}
