package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.app.head.SceneMapBuilder;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Boxes that confine the viewer horizontally, whatever moves it: at a side the viewer slides along;
 * its height is free. The box of a ProximitySensor may be rotated; that of a room is axis-aligned,
 * and the viewer keeps the radius of its avatar from it. The class is confined to the thread that
 * steps the world.
 */
final class MovementBounds {
  /**
   * The margin inside a sensor's box, as a share of its size, at which the sensor surely detects
   * the viewer.
   */
  private static final double INSIDE = 1e-4;

  /**
   * A box in local coordinates.
   *
   * @param toBox transformation from world to box coordinates
   * @param low smallest x and z
   * @param high largest x and z
   */
  private record Box(Matrix4dc toBox, double[] low, double[] high) {
    boolean contains(Vector3d point) {
      Vector3d at = toBox.transformPosition(point, new Vector3d());
      return at.x >= low[0] && at.x <= high[0] && at.z >= low[1] && at.z <= high[1];
    }

    /** Returns the nearest point inside the box. */
    Vector3d within(Vector3d point) {
      Vector3d at = toBox.transformPosition(point, new Vector3d());
      at.x = Math.max(low[0], Math.min(high[0], at.x));
      at.z = Math.max(low[1], Math.min(high[1], at.z));
      return toBox.invert(new Matrix4d()).transformPosition(at);
    }
  }

  private final List<Box> boxes = new ArrayList<>();
  private final World world;

  private MovementBounds(World world) {
    this.world = world;
  }

  /** Creates an enclosure without boxes, which confines nothing. */
  static MovementBounds open(Walkthrough walk) {
    return new MovementBounds(walk.world());
  }

  /** Adds the room that contains the viewer; returns false when there is none. */
  boolean addRoom() {
    Vector3d at = new Vector3d(world.viewer().position());
    return SceneMapBuilder.of(world.instances()).rooms().stream()
        .filter(room -> room.contains(at.x, at.y, at.z))
        .findFirst()
        .map(this::add)
        .orElse(false);
  }

  /**
   * Adds the box of a ProximitySensor or of a room.
   *
   * @param name DEF name of the sensor or name of the room
   * @return false when nothing has that name, or the viewer is outside
   */
  boolean add(String name) {
    InstanceTree tree = world.instances();
    for (Node node : tree.otherNodes()) {
      if (node.type().name().equals("ProximitySensor") && name.equals(node.name())) {
        for (Matrix4dc place : tree.places(node)) {
          float[] center = node.floats("center");
          float[] size = node.floats("size");
          double share = 0.5 - INSIDE;
          return add(
              new Box(
                  place.invert(new Matrix4d()),
                  new double[] {center[0] - share * size[0], center[2] - share * size[2]},
                  new double[] {center[0] + share * size[0], center[2] + share * size[2]}));
        }
      }
    }
    Optional<SceneMap.Box> room =
        SceneMapBuilder.of(tree).rooms().stream()
            .filter(box -> box.name().equals(name))
            .findFirst();
    return room.map(this::add).orElse(false);
  }

  private boolean add(SceneMap.Box room) {
    double body =
        world
            .bindables()
            .bound("NavigationInfo")
            .map(NavigationParameters::of)
            .orElse(NavigationParameters.WALKING)
            .radius();
    double[] b = room.bounds();
    return add(
        new Box(
            new Matrix4d(),
            new double[] {b[0] + body, b[2] + body},
            new double[] {b[3] - body, b[5] - body}));
  }

  private boolean add(Box box) {
    if (!box.contains(new Vector3d(world.viewer().position()))) {
      return false;
    }
    boxes.add(box);
    return true;
  }

  /** Returns a motion that follows another one and keeps the viewer inside the boxes. */
  ViewerMotion around(ViewerMotion motion) {
    return boxes.isEmpty()
        ? motion
        : (viewer, time, dt) -> {
          motion.move(viewer, time, dt);
          keep(viewer);
        };
  }

  private void keep(Viewer viewer) {
    for (Box box : boxes) {
      Vector3d at = new Vector3d(viewer.position());
      if (!box.contains(at)) {
        viewer.moveTo(box.within(at));
      }
    }
  }

  /** Returns a motion that turns the viewer as another one does and keeps its position. */
  static ViewerMotion standing(Viewer at, ViewerMotion motion) {
    Vector3d home = new Vector3d(at.position());
    return (viewer, time, dt) -> {
      motion.move(viewer, time, dt);
      viewer.moveTo(home);
    };
  }
}
