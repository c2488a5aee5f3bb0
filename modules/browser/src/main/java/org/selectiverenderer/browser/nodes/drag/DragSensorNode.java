package org.selectiverenderer.browser.nodes.drag;

import java.util.Arrays;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.PointerHit;
import org.selectiverenderer.browser.nodes.sensor.PointerRay;
import org.selectiverenderer.browser.nodes.sensor.PointingDeviceSensorNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A sensor that converts dragging to a value (X3D 4.0, X3DDragSensorNode, 20.3.1). Pressing the
 * button over its geometry sends {@code isActive TRUE} and nothing else. Each later move sends
 * {@code trackPoint_changed}, the pointer's position on the drag surface, and the value, which
 * starts at {@code offset}. Releasing it sends {@code isActive FALSE}; with {@code autoOffset} the
 * last value becomes the {@code offset}, which is sent too.
 *
 * <p>A drag continues in the coordinates in which it began, so that a sensor may be in the very
 * group that it moves.
 */
abstract class DragSensorNode extends PointingDeviceSensorNode {
  private final int autoOffset;
  private final int offset;
  private final int trackPoint;
  private final int valueChanged;
  private final Matrix4d toLocal = new Matrix4d();
  private @Nullable DragSurface surface;
  private @Nullable Vector3dc last;
  private @Nullable Object sent;

  /**
   * @param output the output field for the value
   */
  DragSensorNode(NodeType type, @Nullable String name, SourceLocation location, String output) {
    super(type, name, location);
    autoOffset = type.indexOf("autoOffset");
    offset = type.indexOf("offset");
    trackPoint = type.indexOf("trackPoint_changed");
    valueChanged = type.indexOf(output);
  }

  @Override
  public final boolean drags() {
    return true;
  }

  final Object offset() {
    return value(offset);
  }

  /**
   * Returns the surface for a drag that begins now.
   *
   * @param hit the starting point, in local coordinates
   * @param ray the pointer's ray, in local coordinates
   */
  abstract DragSurface surface(Vector3dc hit, DragRay ray);

  @Override
  protected final void grabbed(PointerHit at, PointerRay bearing) {
    sent = null;
    surface = null;
    bearing.place().invert(toLocal);
    if (toLocal.isFinite()) { // Else a scale of 0 above prevents it.
      DragRay ray = ray(bearing);
      surface = surface(at.point(), ray);
      last = surface.follow(ray).orElse(null);
    }
  }

  private DragRay ray(PointerRay bearing) {
    return new DragRay(
        toLocal.transformPosition(bearing.origin(), new Vector3d()),
        toLocal.transformDirection(bearing.direction(), new Vector3d()));
  }

  @Override
  protected final void dragged(PointerRay bearing, EventCascade cascade) {
    DragSurface along = surface;
    if (along == null) {
      return;
    }
    Optional<Vector3d> point = along.follow(ray(bearing));
    if (point.isEmpty() || point.get().equals(last)) {
      return; // A pointer that rests sends nothing.
    }
    last = point.get();
    Object value = along.value(point.get());
    emit(trackPoint, floats(point.get()), cascade);
    if (active() && !same(sent, value)) { // An answer to trackPoint_changed may have disabled it.
      sent = value;
      emit(valueChanged, value, cascade);
    }
  }

  @Override
  protected final void released(boolean over, EventCascade cascade) {
    DragSurface along = surface;
    surface = null;
    if (along != null && sent != null && (Boolean) value(autoOffset)) {
      Object kept = along.offset();
      if (!same(value(offset), kept)) {
        emit(offset, kept, cascade);
      }
    }
  }

  private static boolean same(@Nullable Object a, Object b) {
    return a instanceof float[] floats && b instanceof float[] others
        ? Arrays.equals(floats, others)
        : b.equals(a);
  }

  static float[] floats(Vector3dc v) {
    return new float[] {(float) v.x(), (float) v.y(), (float) v.z()};
  }
}
