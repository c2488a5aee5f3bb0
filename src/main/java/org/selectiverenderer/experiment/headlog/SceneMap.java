package org.selectiverenderer.experiment.headlog;

import java.util.List;

/**
 * What of a scene a log's reader needs to know: where its areas, rooms and objects are, in the
 * world and in the scene's unit of length.
 *
 * @param areas boxes of the sensors
 * @param rooms boxes of the named groups at the top of the scene; where there is none, one of all
 * @param objects boxes of the named Switches
 */
public record SceneMap(List<Area> areas, List<Box> rooms, List<Box> objects) {
  /** A scene of which nothing is known. */
  public static final SceneMap EMPTY = new SceneMap(List.of(), List.of(), List.of());

  public SceneMap {
    areas = List.copyOf(areas);
    rooms = List.copyOf(rooms);
    objects = List.copyOf(objects);
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
