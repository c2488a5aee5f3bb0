package org.selectiverenderer.runtime.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.nodes.sensor.Bearing;
import org.selectiverenderer.runtime.nodes.sensor.PointerHit;
import org.selectiverenderer.runtime.nodes.sensor.PointingSensorNode;
import org.selectiverenderer.runtime.scene.Cascade;

/**
 * Tells TouchSensors and drag sensors what the pointing device does (X3D 4.0, 20.2). A sensor
 * senses the geometry of its parent group; of those above a shape, the ones in the lowest group
 * that has enabled ones hear of it, all of them. While the button is held, only those over which it
 * went down hear of the pointer.
 */
public final class TouchDispatch {
  /**
   * Where the pointer meets a shape, in world coordinates.
   *
   * @param normal of the surface, of unit length
   * @param s texture coordinate
   * @param t texture coordinate
   */
  public record Hit(ShapeInstance shape, Vector3dc point, Vector3dc normal, float s, float t) {}

  /**
   * Where the pointer points, in world coordinates.
   *
   * @param direction of any length but 0
   */
  public record Ray(Vector3dc origin, Vector3dc direction) {}

  private List<PlainInstance> over = List.of();
  private List<PlainInstance> grabbed = List.of();
  private boolean pressedBefore;

  /**
   * The sensors that a pointer over that instance is for; none when an Anchor stands below them.
   */
  public static List<PlainInstance> sensors(Instance hit) {
    for (GroupInstance group = hit.parent(); group != null; group = group.parent()) {
      List<PlainInstance> found = new ArrayList<>(0);
      for (Instance child : group.children()) {
        if (child instanceof PlainInstance place
            && sensor(place).map(s -> s.enabled()).orElse(false)) {
          found.add(place);
        }
      }
      if (!found.isEmpty() || isAnchor(group)) {
        return found;
      }
    }
    return List.of();
  }

  /** The Anchor that a click on that instance activates, unless a sensor stands below it. */
  public static Optional<GroupInstance> anchor(Instance hit) {
    if (sensors(hit).isEmpty()) {
      for (GroupInstance group = hit.parent(); group != null; group = group.parent()) {
        if (isAnchor(group)) {
          return Optional.of(group);
        }
      }
    }
    return Optional.empty();
  }

  private static boolean isAnchor(GroupInstance group) {
    return group.node().type().name().equals("Anchor");
  }

  private static Optional<PointingSensorNode> sensor(PlainInstance place) {
    return place.node() instanceof PointingSensorNode sensor
        ? Optional.of(sensor)
        : Optional.empty();
  }

  /** Whether the button is held for a drag. */
  public boolean dragging() {
    return grabbed.stream()
        .anyMatch(place -> sensor(place).filter(s -> s.drags() && s.active()).isPresent());
  }

  /** Whether pressing the button now begins a drag. */
  public boolean overDragSensor() {
    return over.stream().anyMatch(place -> sensor(place).filter(s -> s.drags()).isPresent());
  }

  /** What the authors of the sensors that are pointed at say of them, once each. */
  public List<String> descriptions() {
    return over.stream()
        .flatMap(place -> sensor(place).stream())
        .map(sensor -> sensor.description().strip())
        .filter(text -> !text.isEmpty())
        .distinct()
        .toList();
  }

  /**
   * The pointer moved, or its button went down or up: once per frame.
   *
   * @param hit the nearest shape that the pointer meets
   * @param ray where it points; empty when it points nowhere
   */
  public void point(Optional<Hit> hit, Optional<Ray> ray, boolean pressed, Cascade cascade) {
    List<PlainInstance> now = hit.map(at -> sensors(at.shape())).orElse(List.of());
    boolean goesDown = pressed && !pressedBefore;
    pressedBefore = pressed;
    if (!grabbed.isEmpty()) {
      for (PlainInstance place : grabbed) {
        tell(place, contains(now, place) ? hit : Optional.empty(), ray, pressed, cascade);
      }
      if (pressed) {
        return;
      }
      over = grabbed;
      grabbed = List.of();
    }
    for (PlainInstance place : over) {
      if (!contains(now, place)) {
        tell(place, Optional.empty(), ray, false, cascade);
      }
    }
    for (PlainInstance place : now) {
      tell(place, hit, ray, goesDown, cascade);
    }
    over = now;
    grabbed = goesDown ? now : List.of();
  }

  /** Whether the same node is among them, in whatever place. */
  private static boolean contains(List<PlainInstance> places, PlainInstance wanted) {
    return places.stream().anyMatch(place -> place.node() == wanted.node());
  }

  private static void tell(
      PlainInstance place, Optional<Hit> hit, Optional<Ray> ray, boolean pressed, Cascade cascade) {
    sensor(place)
        .ifPresent(
            sensor ->
                sensor.point(
                    hit.map(at -> local(at, place.world())),
                    ray.map(to -> new Bearing(to.origin(), to.direction(), place.world())),
                    pressed,
                    cascade));
  }

  private static PointerHit local(Hit hit, Matrix4dc world) {
    Vector3d point = world.invert(new Matrix4d()).transformPosition(hit.point(), new Vector3d());
    Vector3d normal =
        new Vector3d(
                world.m00() * hit.normal().x()
                    + world.m01() * hit.normal().y()
                    + world.m02() * hit.normal().z(),
                world.m10() * hit.normal().x()
                    + world.m11() * hit.normal().y()
                    + world.m12() * hit.normal().z(),
                world.m20() * hit.normal().x()
                    + world.m21() * hit.normal().y()
                    + world.m22() * hit.normal().z())
            .normalize();
    return new PointerHit(point, normal, hit.s(), hit.t());
  }
}
