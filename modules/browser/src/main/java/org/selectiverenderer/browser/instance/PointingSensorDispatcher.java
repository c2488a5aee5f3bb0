package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.nodes.sensor.PointerHit;
import org.selectiverenderer.browser.nodes.sensor.PointerRay;
import org.selectiverenderer.browser.nodes.sensor.PointingDeviceSensorNode;
import org.selectiverenderer.browser.scene.EventCascade;

/**
 * Dispatches the pointing device to TouchSensors and drag sensors (X3D 4.0, 20.2). A sensor senses
 * the geometry of its parent group. For a shape, all enabled sensors of the lowest group above it
 * that has any are addressed. While the button is held, only the sensors over which it went down
 * are addressed.
 */
public final class PointingSensorDispatcher {
  /**
   * The point at which the pointer hits a shape, in world coordinates.
   *
   * @param normal the surface normal, of unit length
   * @param s the first texture coordinate
   * @param t the second texture coordinate
   */
  public record Hit(ShapeInstance shape, Vector3dc point, Vector3dc normal, float s, float t) {}

  /**
   * The ray of the pointer, in world coordinates.
   *
   * @param direction the direction, of any length but 0
   */
  public record Ray(Vector3dc origin, Vector3dc direction) {}

  private List<NonVisualInstance> over = List.of();
  private List<NonVisualInstance> grabbed = List.of();
  private boolean pressedBefore;

  /**
   * Returns the sensors addressed by a pointer over an instance; none if an Anchor is nearer to the
   * instance.
   */
  public static List<NonVisualInstance> sensors(Instance hit) {
    for (GroupInstance group = hit.parent(); group != null; group = group.parent()) {
      List<NonVisualInstance> found = new ArrayList<>(0);
      for (Instance child : group.children()) {
        if (child instanceof NonVisualInstance place
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

  /**
   * Returns the Anchor that a click on an instance activates, unless a sensor is nearer to the
   * instance.
   */
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

  private static Optional<PointingDeviceSensorNode> sensor(NonVisualInstance place) {
    return place.node() instanceof PointingDeviceSensorNode sensor
        ? Optional.of(sensor)
        : Optional.empty();
  }

  /** Returns whether a drag sensor has grabbed the pointer. */
  public boolean dragging() {
    return grabbed.stream()
        .anyMatch(place -> sensor(place).filter(s -> s.drags() && s.active()).isPresent());
  }

  /** Returns whether pressing the button now would begin a drag. */
  public boolean overDragSensor() {
    return over.stream().anyMatch(place -> sensor(place).filter(s -> s.drags()).isPresent());
  }

  /** Returns the descriptions of the sensors under the pointer, each once. */
  public List<String> descriptions() {
    return over.stream()
        .flatMap(place -> sensor(place).stream())
        .map(sensor -> sensor.description().strip())
        .filter(text -> !text.isEmpty())
        .distinct()
        .toList();
  }

  /**
   * Evaluates a state of the pointer; called at least once per frame.
   *
   * @param hit the nearest shape that the pointer hits
   * @param ray the ray of the pointer; empty if it points at nothing
   */
  public void point(Optional<Hit> hit, Optional<Ray> ray, boolean pressed, EventCascade cascade) {
    List<NonVisualInstance> now = hit.map(at -> sensors(at.shape())).orElse(List.of());
    boolean goesDown = pressed && !pressedBefore;
    pressedBefore = pressed;
    if (!grabbed.isEmpty()) {
      for (NonVisualInstance place : grabbed) {
        tell(place, contains(now, place) ? hit : Optional.empty(), ray, pressed, cascade);
      }
      if (pressed) {
        return;
      }
      over = grabbed;
      grabbed = List.of();
    }
    for (NonVisualInstance place : over) {
      if (!contains(now, place)) {
        tell(place, Optional.empty(), ray, false, cascade);
      }
    }
    for (NonVisualInstance place : now) {
      tell(place, hit, ray, goesDown, cascade);
    }
    over = now;
    grabbed = goesDown ? now : List.of();
  }

  /** Returns whether an instance of the same node is in a list. */
  private static boolean contains(List<NonVisualInstance> places, NonVisualInstance wanted) {
    return places.stream().anyMatch(place -> place.node() == wanted.node());
  }

  private static void tell(
      NonVisualInstance place,
      Optional<Hit> hit,
      Optional<Ray> ray,
      boolean pressed,
      EventCascade cascade) {
    sensor(place)
        .ifPresent(
            sensor ->
                sensor.point(
                    hit.map(at -> local(at, place.world())),
                    ray.map(to -> new PointerRay(to.origin(), to.direction(), place.world())),
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
