package org.selectiverenderer.runtime;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.TouchDispatch;
import org.selectiverenderer.runtime.navigation.MeshBvhs;
import org.selectiverenderer.runtime.navigation.RayCaster;
import org.selectiverenderer.runtime.navigation.Viewer;
import org.selectiverenderer.runtime.nodes.TouchSensorNode;
import org.selectiverenderer.runtime.scene.Cascade;

/**
 * Takes the pointing device to the TouchSensors and Anchors of a scene. What it says between two
 * frames is evaluated in order, so that no click is lost, and its last word again in every frame,
 * since viewer and scene move under it. An Anchor is activated when the button is released where it
 * was pressed.
 */
final class Pointing {
  private final InstanceTree instances;
  private final RayCaster rays;
  private final Consumer<GroupInstance> activated;
  private final TouchDispatch touch = new TouchDispatch();
  private Pointer last = Pointer.AWAY;
  private Optional<GroupInstance> pressedOn = Optional.empty();
  private long structure = -1;
  private boolean anythingToTouch;

  /**
   * @param activated hears of an Anchor that the user clicked on
   */
  Pointing(InstanceTree instances, MeshBvhs meshes, Consumer<GroupInstance> activated) {
    this.instances = instances;
    this.activated = activated;
    rays = new RayCaster(instances, meshes);
  }

  /**
   * @param since what the device said since the last frame, oldest first
   */
  void frame(List<Pointer> since, Viewer viewer, Cascade cascade) {
    if (structure != instances.structureVersion()) {
      structure = instances.structureVersion();
      anythingToTouch =
          instances.otherNodes().stream().anyMatch(TouchSensorNode.class::isInstance)
              || hasAnchor();
    }
    if (!anythingToTouch) {
      last = since.isEmpty() ? last : since.get(since.size() - 1);
      return;
    }
    if (since.isEmpty()) {
      point(last, viewer, cascade);
    } else {
      since.forEach(pointer -> point(pointer, viewer, cascade));
    }
  }

  private boolean hasAnchor() {
    ArrayDeque<GroupInstance> open = new ArrayDeque<>(List.of(instances.root()));
    while (!open.isEmpty()) {
      GroupInstance group = open.pop();
      if (group.node().type().name().equals("Anchor")) {
        return true;
      }
      group.children().stream()
          .filter(GroupInstance.class::isInstance)
          .forEach(child -> open.push((GroupInstance) child));
    }
    return false;
  }

  private void point(Pointer pointer, Viewer viewer, Cascade cascade) {
    Optional<TouchDispatch.Hit> hit =
        pointer
            .direction()
            .map(direction -> viewer.orientation().transform(direction, new Vector3d()))
            .flatMap((Vector3dc ray) -> rays.cast(viewer.position(), ray, Double.POSITIVE_INFINITY))
            .map(Pointing::touched);
    touch.point(hit, pointer.pressed(), cascade);
    Optional<GroupInstance> anchor = hit.flatMap(at -> TouchDispatch.anchor(at.shape()));
    if (pointer.pressed() && !last.pressed()) {
      pressedOn = anchor;
    } else if (!pointer.pressed() && last.pressed()) {
      pressedOn.filter(on -> anchor.filter(now -> now == on).isPresent()).ifPresent(activated);
      pressedOn = Optional.empty();
    }
    last = pointer;
  }

  private static TouchDispatch.Hit touched(RayCaster.Hit hit) {
    Vector2d texCoord = hit.texCoord();
    return new TouchDispatch.Hit(
        hit.shape(),
        hit.point(),
        hit.normal(),
        texCoord == null ? 0 : (float) texCoord.x,
        texCoord == null ? 0 : (float) texCoord.y);
  }
}
