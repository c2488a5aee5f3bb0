package org.selectiverenderer.browser;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Vector2d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.PointingSensorDispatcher;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.viewer.ViewRay;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * Passes the pointing device to the TouchSensors, drag sensors and Anchors of a layer. All states
 * between two frames are evaluated in order, so that no click is lost; the last state is evaluated
 * again in every frame, since viewer and scene move under the pointer. An Anchor is activated when
 * the button is released over the Anchor on which it was pressed.
 */
final class PointingDeviceHandler {
  private final InstanceTree instances;
  private final MeshBvhCache meshes;
  private @Nullable RayCaster rays;
  private final Consumer<GroupInstance> activated;
  private final PointingSensorDispatcher touch = new PointingSensorDispatcher();
  private PointingDeviceState last = PointingDeviceState.AWAY;
  private Optional<GroupInstance> pressedOn = Optional.empty();
  private Optional<GroupInstance> pointedAnchor = Optional.empty();
  private boolean touchable;

  /**
   * @param activated called with each Anchor that the user clicked
   */
  PointingDeviceHandler(
      InstanceTree instances, MeshBvhCache meshes, Consumer<GroupInstance> activated) {
    this.instances = instances;
    this.activated = activated;
    this.meshes = meshes;
  }

  /**
   * Sets whether the layer has a pointing device sensor or an Anchor; without any, no ray is cast.
   */
  void touchable(boolean anything) {
    touchable = anything;
  }

  /**
   * Returns whether a drag sensor has grabbed the pointer, or would grab it if the button went
   * down.
   */
  boolean wantsDrag() {
    return touchable && (touch.dragging() || touch.overDragSensor());
  }

  /** Returns whether a drag sensor has grabbed the pointer. */
  boolean dragging() {
    return touchable && touch.dragging();
  }

  /** Returns the author's descriptions of the sensors or Anchor under the pointer. */
  List<String> descriptions() {
    if (!touchable || pointedAnchor.isEmpty()) {
      return touchable ? touch.descriptions() : List.of();
    }
    String text = pointedAnchor.get().node().value("description") instanceof String s ? s : "";
    return text.isBlank() ? List.of() : List.of(text.strip());
  }

  /**
   * @param since the pointer states since the last frame, oldest first
   */
  void frame(List<PointingDeviceState> since, Viewer viewer, EventCascade cascade) {
    if (!touchable) {
      last = since.isEmpty() ? last : since.get(since.size() - 1);
      return;
    }
    if (since.isEmpty()) {
      point(last, viewer, cascade);
    } else {
      since.forEach(pointer -> point(pointer, viewer, cascade));
    }
  }

  /** Returns whether the pointer is over any shape. */
  boolean meets(PointingDeviceState pointer, Viewer viewer) {
    return ray(pointer, viewer).flatMap(this::cast).isPresent();
  }

  private static Optional<PointingSensorDispatcher.Ray> ray(
      PointingDeviceState pointer, Viewer viewer) {
    return pointer
        .direction()
        .map(direction -> ViewRay.of(viewer, direction, pointer.aspect()))
        .map(ray -> new PointingSensorDispatcher.Ray(ray.origin(), ray.direction()));
  }

  private Optional<RayCaster.Hit> cast(PointingSensorDispatcher.Ray ray) {
    return rays().cast(ray.origin(), ray.direction(), Double.POSITIVE_INFINITY);
  }

  /** Returns the last state of the device. */
  PointingDeviceState last() {
    return last;
  }

  /**
   * Returns the shape under the pointer, unless a sensor or Anchor of the scene takes clicks there.
   */
  Optional<ShapeInstance> idle(PointingDeviceState pointer, Viewer viewer) {
    return ray(pointer, viewer)
        .flatMap(this::cast)
        .map(RayCaster.Hit::shape)
        .filter(
            at ->
                PointingSensorDispatcher.sensors(at).isEmpty()
                    && PointingSensorDispatcher.anchor(at).isEmpty());
  }

  private void point(PointingDeviceState pointer, Viewer viewer, EventCascade cascade) {
    Optional<PointingSensorDispatcher.Ray> ray = ray(pointer, viewer);
    Optional<PointingSensorDispatcher.Hit> hit =
        ray.flatMap(this::cast).map(PointingDeviceHandler::touched);
    touch.point(hit, ray, pointer.pressed(), cascade);
    Optional<GroupInstance> anchor = hit.flatMap(at -> PointingSensorDispatcher.anchor(at.shape()));
    pointedAnchor = anchor;
    if (pointer.pressed() && !last.pressed()) {
      pressedOn = anchor;
    } else if (!pointer.pressed() && last.pressed()) {
      pressedOn.filter(on -> anchor.filter(now -> now == on).isPresent()).ifPresent(activated);
      pressedOn = Optional.empty();
    }
    last = pointer;
  }

  private RayCaster rays() {
    if (rays == null) {
      rays = new RayCaster(instances, meshes);
    }
    return rays;
  }

  private static PointingSensorDispatcher.Hit touched(RayCaster.Hit hit) {
    Vector2d texCoord = hit.texCoord();
    return new PointingSensorDispatcher.Hit(
        hit.shape(),
        hit.point(),
        hit.normal(),
        texCoord == null ? 0 : (float) texCoord.x,
        texCoord == null ? 0 : (float) texCoord.y);
  }
}
