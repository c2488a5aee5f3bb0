package org.selectiverenderer.apartment.plan;

/**
 * The three rooms side by side, lounge, kitchen and office from west to east. The walls stand where
 * the sensor boxes of thesis Fig 76 end: the sofa's from x = -8.725 to -2.197 and to z = 3.221, the
 * bookcase's from x = 2.319 and z = -3.220, the desk's to x = 8.723. Lengths are inside, in metres.
 */
public enum Room {
  KITCHEN("Kitchen", -2.08, 2.20, 12744),
  LOUNGE("Lounge", -8.73, -2.20, 5922),
  OFFICE("Office", 2.32, 8.74, 5184);

  /** World y of the floor, at the lower side of the desk's sensor (thesis Fig 76). */
  public static final double FLOOR = -1.946;

  /** Height from floor to ceiling. */
  public static final double HEIGHT = 2.6;

  /** Height of the ceiling's face, a little lower than the walls' upper ends. */
  public static final double CEILING = HEIGHT - 0.001;

  public static final double NORTH = -3.23;
  public static final double SOUTH = 3.23;

  /** Thickness of each room's half of the wall between two rooms. */
  static final double INNER_WALL = 0.06;

  static final double OUTER_WALL = 0.2;

  private final String title;
  private final double west;
  private final double east;
  private final int fixedPolygons;

  Room(String title, double west, double east, int fixedPolygons) {
    this.title = title;
    this.west = west;
    this.east = east;
    this.fixedPolygons = fixedPolygons;
  }

  /** Returns the DEF name of its Group. */
  public String title() {
    return title;
  }

  /** Returns the memory schema of the room as a whole. */
  public String schema() {
    return title + "Schema";
  }

  public double west() {
    return west;
  }

  public double east() {
    return east;
  }

  public double middle() {
    return (west + east) / 2;
  }

  /**
   * Returns the polygons of everything that has one version, the room itself and the inconsistent
   * objects: the remainder of the totals of thesis Tables 3 to 5 beside the listed objects.
   */
  public int fixedPolygons() {
    return fixedPolygons;
  }

  /** Returns the thickness of this room's part of a wall. */
  public double thickness(WallSide side) {
    boolean inner =
        switch (side) {
          case NORTH, SOUTH -> false;
          case EAST -> this != OFFICE;
          case WEST -> this != LOUNGE;
        };
    return inner ? INNER_WALL : OUTER_WALL;
  }
}
