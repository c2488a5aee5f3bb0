package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.experiment.headlog.SceneMap;
import org.selectiverenderer.experiment.headlog.SceneSurvey;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.runtime.walk.Navigation;

/**
 * Boxes that a viewer does not leave, whatever moves it: at a side it slides along. Height is not
 * its business. A ProximitySensor's box may be turned; a room's stands along the axes, and the
 * viewer keeps the distance of its body from it. Belongs to the thread that steps the world.
 */
final class Enclosure {
  /** So far inside of a sensor, as a share of its size, the sensor is sure to see the viewer. */
  private static final double INSIDE = 1e-4;

  /**
   * A box in coordinates of its own.
   *
   * @param toBox from the world
   * @param low x and z of its sides
   * @param high x and z of its sides
   */
  private record Box(Matrix4dc toBox, double[] low, double[] high) {
    boolean contains(Vector3d point) {
      Vector3d at = toBox.transformPosition(point, new Vector3d());
      return at.x >= low[0] && at.x <= high[0] && at.z >= low[1] && at.z <= high[1];
    }

    /** The nearest point within. */
    Vector3d within(Vector3d point) {
      Vector3d at = toBox.transformPosition(point, new Vector3d());
      at.x = Math.max(low[0], Math.min(high[0], at.x));
      at.z = Math.max(low[1], Math.min(high[1], at.z));
      return toBox.invert(new Matrix4d()).transformPosition(at);
    }
  }

  private final List<Box> boxes = new ArrayList<>();
  private final World world;

  private Enclosure(World world) {
    this.world = world;
  }

  /** Around everything. */
  static Enclosure open(Walkthrough walk) {
    return new Enclosure(walk.world());
  }

  /** The room that the viewer is in, besides; false when it is in none. */
  boolean addRoom() {
    Vector3d at = new Vector3d(world.viewer().position());
    return SceneSurvey.of(world.instances()).rooms().stream()
        .filter(room -> room.contains(at.x, at.y, at.z))
        .findFirst()
        .map(this::add)
        .orElse(false);
  }

  /**
   * The box of a ProximitySensor, or of a room, besides.
   *
   * @param name its DEF
   * @return false when there is none of that name, or the viewer is not in it
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
        SceneSurvey.of(tree).rooms().stream().filter(box -> box.name().equals(name)).findFirst();
    return room.map(this::add).orElse(false);
  }

  private boolean add(SceneMap.Box room) {
    double body =
        world
            .bindables()
            .bound("NavigationInfo")
            .map(Navigation::of)
            .orElse(Navigation.WALKING)
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

  /** Moves the viewer as something else does, as far as the boxes let it. */
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

  /** Turns the viewer as something else does, and leaves it where it is. */
  static ViewerMotion standing(Viewer at, ViewerMotion motion) {
    Vector3d home = new Vector3d(at.position());
    return (viewer, time, dt) -> {
      motion.move(viewer, time, dt);
      viewer.moveTo(home);
    };
  }
}
