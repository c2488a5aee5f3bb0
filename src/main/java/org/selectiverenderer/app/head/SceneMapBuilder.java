package org.selectiverenderer.app.head;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.study.headlog.SceneMap.Area;
import org.selectiverenderer.study.headlog.SceneMap.Box;

/** Builds the {@link SceneMap} of a running scene. Belongs to the thread that steps the world. */
public final class SceneMapBuilder {
  /**
   * Share of a room's edge that a wall, floor or ceiling must reach along; skirting boards and
   * corners shorten it.
   */
  private static final double ALONG = 0.9;

  private SceneMapBuilder() {}

  /** Returns the map of all that the instance tree holds now, visible or not. */
  public static SceneMap of(InstanceTree tree) {
    List<Area> areas = new ArrayList<>();
    for (Node node : tree.otherNodes()) {
      if (node.type().name().equals("ProximitySensor")) {
        for (Matrix4dc place : tree.places(node)) {
          areas.add(area(node, place));
        }
      }
    }
    SceneObjectResolver known = new SceneObjectResolver(tree);
    List<Box> rooms = new ArrayList<>();
    for (Instance child : tree.root().children()) {
      if (child instanceof GroupInstance group && named(group.node()) && known.isRoom(group)) {
        add(rooms, group.node(), bounds(group));
      }
    }
    if (rooms.isEmpty()) {
      double[] all = bounds(tree.root());
      if (all[0] <= all[3]) {
        rooms.add(new Box("scene", all));
      }
    }
    Map<Node, double[]> extents = new LinkedHashMap<>();
    for (ShapeInstance shape : tree.shapes()) {
      known
          .of(shape)
          .ifPresent(
              object ->
                  grow(extents.computeIfAbsent(object.node(), n -> nothing()), shape.bounds()));
    }
    List<Box> all = new ArrayList<>();
    extents.forEach((node, box) -> add(all, node, box));
    Map<Boolean, List<Box>> apart =
        all.stream()
            .collect(Collectors.partitioningBy(box -> all.size() > 1 && surrounds(box, rooms)));
    return new SceneMap(areas, rooms, apart.get(false), apart.get(true));
  }

  /**
   * Returns whether a box is a part of a room's shell, not an object in it: it has the name of the
   * room, or reaches along two of the room's three edges, as floor, ceiling and walls do.
   */
  private static boolean surrounds(Box box, List<Box> rooms) {
    return rooms.stream()
        .anyMatch(room -> room.name().equals(box.name()) || edges(box.bounds(), room.bounds()) > 1);
  }

  /** Returns along how many of a room's edges a box reaches; 0 if it lies outside of the room. */
  private static int edges(double[] box, double[] room) {
    int edges = 0;
    for (int axis = 0; axis < 3; axis++) {
      double common = Math.min(room[axis + 3], box[axis + 3]) - Math.max(room[axis], box[axis]);
      if (common < 0) {
        return 0;
      }
      edges += common >= ALONG * (room[axis + 3] - room[axis]) ? 1 : 0;
    }
    return edges;
  }

  private static boolean named(Node node) {
    String name = node.name();
    return name != null && !name.isEmpty();
  }

  private static void add(List<Box> boxes, Node node, double[] bounds) {
    if (bounds[0] <= bounds[3]) {
      boxes.add(new Box(String.valueOf(node.name()), bounds));
    }
  }

  /**
   * Returns the outline of a sensor's box seen from above: its horizontal midsection, transformed
   * to the world.
   */
  private static Area area(Node sensor, Matrix4dc place) {
    float[] center = sensor.floats("center");
    float[] size = sensor.floats("size");
    List<double[]> outline = new ArrayList<>();
    for (int[] side : new int[][] {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      Vector3d corner =
          place.transformPosition(
              new Vector3d(
                  center[0] + side[0] * size[0] / 2, center[1], center[2] + side[1] * size[2] / 2));
      outline.add(new double[] {corner.x, corner.z});
    }
    return new Area(named(sensor) ? String.valueOf(sensor.name()) : "area", outline);
  }

  private static double[] bounds(Instance instance) {
    double[] box = nothing();
    grow(box, instance);
    return box;
  }

  private static void grow(double[] box, @Nullable Instance instance) {
    if (instance instanceof ShapeInstance shape) {
      grow(box, shape.bounds());
    } else if (instance instanceof GroupInstance group) {
      group.children().forEach(child -> grow(box, child));
    }
  }

  private static double[] nothing() {
    double[] box = new double[6];
    Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
    Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
    return box;
  }

  private static void grow(double[] box, double[] other) {
    if (other[0] > other[3]) {
      return;
    }
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis], other[axis]);
      box[axis + 3] = Math.max(box[axis + 3], other[axis + 3]);
    }
  }
}
