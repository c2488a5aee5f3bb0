package org.selectiverenderer.bench;

import java.util.Locale;

/** Floor, walls and areas of the heavy scene's rooms. */
final class RoomText {

  private static final double HALF_DEPTH = 3.5;
  private static final double WALL = 2.6;

  private RoomText() {}

  /**
   * @param bounds x of the walls across, from west to east; the inner ones are knee-high
   */
  static void append(StringBuilder text, double... bounds) {
    double west = bounds[0];
    double east = bounds[bounds.length - 1];
    double middle = (west + east) / 2;
    double width = east - west;
    box(text, "0.62 0.56 0.48", middle, -0.05, 0, width, 0.1, 2 * HALF_DEPTH);
    for (int side = -1; side <= 1; side += 2) {
      box(text, WALLS, middle, WALL / 2, side * (HALF_DEPTH + 0.05), width, WALL, 0.1);
    }
    box(text, WALLS, west - 0.05, WALL / 2, 0, 0.1, WALL, 2 * HALF_DEPTH);
    box(text, WALLS, east + 0.05, WALL / 2, 0, 0.1, WALL, 2 * HALF_DEPTH);
    for (int i = 1; i + 1 < bounds.length; i++) {
      box(text, WALLS, bounds[i], 0.25, 0, 0.08, 0.5, 2 * HALF_DEPTH);
    }
    for (int room = 1; room < bounds.length; room++) {
      sensor(text, room, bounds[room - 1], bounds[room]);
    }
  }

  private static final String WALLS = "0.85 0.82 0.75";

  private static void box(
      StringBuilder text,
      String colour,
      double x,
      double y,
      double z,
      double width,
      double height,
      double depth) {
    text.append(
        String.format(
            Locale.ROOT,
            """
                <Transform translation='%.3f %.3f %.3f'>
                  <Shape>
                    <Appearance>
                      <Material diffuseColor='%s'/>
                    </Appearance>
                    <Box size='%.3f %.3f %.3f'/>
                  </Shape>
                </Transform>
            """,
            x,
            y,
            z,
            colour,
            width,
            height,
            depth));
  }

  private static void sensor(StringBuilder text, int room, double west, double east) {
    text.append(
        String.format(
            Locale.ROOT,
            """
                <ProximitySensor DEF='Room%1$dProx' enabled='false' center='%2$.3f 1.3 0' size='%3$.3f 2.6 7'>
                  <MetadataSet containerField='metadata'>
                    <MetadataString containerField='value' name='enterTimeSchema' value='"Room%1$dSchema"'/>
                    <MetadataString containerField='value' name='exitTimeSchema' value='"HouseSchema"'/>
                  </MetadataSet>
                </ProximitySensor>
            """,
            room,
            (west + east) / 2,
            east - west));
  }
}
