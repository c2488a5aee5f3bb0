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
 * Converts dragging to a translation in a plane (X3D 4.0, 20.4.2). The plane contains the point at
 * which the drag begins and is parallel to z = 0 of the coordinates rotated by {@code
 * axisRotation}. In those coordinates {@code minPosition} and {@code maxPosition} limit the
 * translation on each axis whose minimum is not above its maximum. The value sent is in the
 * sensor's own local coordinates, so that a sibling Transform moves along with the pointer.
 */
final class PlaneSensorNode extends DragSensorNode {
  private final int axisRotation;
  private final int minPosition;
  private final int maxPosition;

  PlaneSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location, "translation_changed");
    axisRotation = type.indexOf("axisRotation");
    minPosition = type.indexOf("minPosition");
    maxPosition = type.indexOf("maxPosition");
  }

  @Override
  DragSurface surface(Vector3dc hit, DragRay ray) {
    Quaterniond turned = Rotations.read((float[]) value(axisRotation), 0, new Quaterniond());
    Vector3d normal = turned.transform(new Vector3d(0, 0, 1));
    Vector3d start = ray.onPlane(hit, normal).orElseGet(() -> new Vector3d(hit));
    float[] begin = (float[]) offset();
    Vector3d offset = new Vector3d(begin[0], begin[1], begin[2]);
    return new DragSurface() {
      private float[] last = begin;

      @Override
      public Optional<Vector3d> follow(DragRay to) {
        return to.onPlane(hit, normal);
      }

      @Override
      public Object value(Vector3dc point) {
        Vector3d way = point.sub(start, new Vector3d()).add(offset);
        turned.transformInverse(way);
        way.x = limited(way.x, 0);
        way.y = limited(way.y, 1);
        last = floats(turned.transform(way));
        return last;
      }

      @Override
      public Object offset() {
        return last;
      }
    };
  }

  private double limited(double value, int axis) {
    double min = ((float[]) value(minPosition))[axis];
    double max = ((float[]) value(maxPosition))[axis];
    return min <= max ? Math.max(min, Math.min(max, value)) : value;
  }
}
