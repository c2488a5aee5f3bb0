package org.selectiverenderer.study.headlog;

import java.util.List;

/**
 * The layout of a scene for readers of a head log: where its areas, rooms and objects are, in world
 * coordinates and the scene's unit of length.
 *
 * @param areas outlines of the ProximitySensors' boxes
 * @param rooms boxes of the named groups at the top level of the scene that hold objects; if there
 *     is none, one box of the whole scene
 * @param objects boxes of all named objects, with versions or without
 * @param surroundings boxes of named walls, floors and ceilings
 */
public record SceneMap(
    List<Area> areas, List<Box> rooms, List<Box> objects, List<Box> surroundings) {
  /** The map of an unknown scene. */
  public static final SceneMap EMPTY = new SceneMap(List.of(), List.of(), List.of(), List.of());

  public SceneMap {
    areas = List.copyOf(areas);
    rooms = List.copyOf(rooms);
    objects = List.copyOf(objects);
    surroundings = List.copyOf(surroundings);
  }

  /** Returns whether a name is that of a wall, a floor or a ceiling. */
  boolean surrounds(String name) {
    return surroundings.stream().anyMatch(box -> box.name().equals(name));
  }

  /** Returns the room in which the centre of an object lies; empty if it lies in none. */
  public String roomOf(Box object) {
    double[] b = object.bounds();
    return rooms.stream()
        .filter(room -> room.contains((b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2))
        .map(Box::name)
        .findFirst()
        .orElse("");
  }

  /**
   * The box of a ProximitySensor seen from above.
   *
   * @param outline x and z of its corners in order
   */
  public record Area(String name, List<double[]> outline) {
    public Area {
      outline = List.copyOf(outline);
    }
  }

  /**
   * An axis-aligned box.
   *
   * @param bounds min x, y, z, max x, y, z
   */
  public record Box(String name, double[] bounds) {
    /** Returns whether a point lies in the box. */
    public boolean contains(double x, double y, double z) {
      return x >= bounds[0]
          && x <= bounds[3]
          && y >= bounds[1]
          && y <= bounds[4]
          && z >= bounds[2]
          && z <= bounds[5];
    }
  }
}
