package org.selectiverenderer.scenes;

import java.util.List;
import org.selectiverenderer.scenes.Lathe.Cap;
import org.selectiverenderer.scenes.Lathe.Ring;

/**
 * The trash can of the thesis in its two versions: 1064 and 93 polygons (thesis Fig 71).
 *
 * <p>Both are 0.32 m high, 0.306 m wide at the rim, open at the top, and stand on y = 0.
 */
final class TrashCan {

  private TrashCan() {}

  /**
   * Ribs and a rolled rim: 28 steps of a profile with 18 bands and two centres, 28 * (18 * 2 + 2) =
   * 1064 triangles.
   */
  static TriangleMesh v1() {
    List<Ring> profile =
        List.of(
            new Ring(0.106, 0),
            new Ring(0.111, 0.004),
            // Three ribs on a wall that widens from 0.111 to 0.144.
            new Ring(0.1165, 0.054),
            new Ring(0.1235, 0.064),
            new Ring(0.1187, 0.074),
            new Ring(0.1262, 0.142),
            new Ring(0.1332, 0.152),
            new Ring(0.1284, 0.162),
            new Ring(0.1359, 0.230),
            new Ring(0.1429, 0.240),
            new Ring(0.1381, 0.250),
            // The rolled rim.
            new Ring(0.1430, 0.295),
            new Ring(0.1515, 0.3),
            new Ring(0.153, 0.311),
            new Ring(0.1465, 0.32),
            new Ring(0.1385, 0.314),
            // The inner wall, and the edge of the floor inside.
            new Ring(0.138, 0.296),
            new Ring(0.108, 0.016),
            new Ring(0.1, 0.008));
    return new Lathe(28, profile, Cap.CENTRE, Cap.CENTRE).mesh();
  }

  /**
   * Outer wall, inner wall and floor: 19 steps of two bands, and 17 triangles between the 19 points
   * of the floor, 2 * 2 * 19 + 17 = 93 triangles. Nobody sees it from below, so there is no
   * underside.
   */
  static TriangleMesh v2() {
    List<Ring> profile = List.of(new Ring(0.108, 0), new Ring(0.153, 0.32), new Ring(0.104, 0.008));
    return new Lathe(19, profile, Cap.NONE, Cap.CHORDS).mesh();
  }
}
