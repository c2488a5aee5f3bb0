package org.selectiverenderer.experiment.headlog;

import java.util.List;

/**
 * What of a scene a log's reader needs to know: where its areas, rooms and objects are, in the
 * world and in the scene's unit of length.
 *
 * @param areas boxes of the sensors
 * @param rooms boxes of the named groups at the top of the scene that hold objects; where there is
 *     none, one of all
 * @param objects boxes of all that has a name, with versions or without ({@link SceneObjects})
 * @param surroundings boxes of what has a name and is no object in a room: its walls, floor,
 *     ceiling
 */
public record SceneMap(
    List<Area> areas, List<Box> rooms, List<Box> objects, List<Box> surroundings) {
  /** A scene of which nothing is known. */
  public static final SceneMap EMPTY = new SceneMap(List.of(), List.of(), List.of(), List.of());

  public SceneMap {
    areas = List.copyOf(areas);
    rooms = List.copyOf(rooms);
    objects = List.copyOf(objects);
    surroundings = List.copyOf(surroundings);
  }

  /** Whether a name is that of a wall, a floor or a ceiling. */
  boolean surrounds(String name) {
    return surroundings.stream().anyMatch(box -> box.name().equals(name));
  }

  /** The room in which the middle of an object lies; empty when it lies in none. */
  String roomOf(Box object) {
    double[] b = object.bounds();
    return rooms.stream()
        .filter(room -> room.contains((b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2))
        .map(Box::name)
        .findFirst()
        .orElse("");
  }

  /**
   * A sensor's box from above.
   *
   * @param outline x, z of its corners in turn
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
    /** Whether a point lies in it. */
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
