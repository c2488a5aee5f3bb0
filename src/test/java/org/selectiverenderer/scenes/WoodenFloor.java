package org.selectiverenderer.scenes;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Floor boards with staggered joints, one face and one of six browns for each board.
 *
 * <p>Faces, not a texture: the joints stay sharp from any distance, and the many corners let a
 * browser that lights per vertex show a lamp's pool of light.
 */
final class WoodenFloor {

  /** Metres in x and z; the floor's first corner is the origin, its top is y = 0. */
  static final double WIDTH = 5.2;

  static final double DEPTH = 5.5;

  private static final int ROWS = 40;
  private static final double BOARD = 1.2;
  private static final String BROWNS =
      "0.62 0.45 0.29 0.59 0.42 0.27 0.65 0.48 0.32 0.56 0.4 0.25 0.61 0.44 0.29 0.67 0.5 0.34";

  private WoodenFloor() {}

  static void write(X3dWriter out) {
    StringBuilder points = new StringBuilder();
    StringBuilder faces = new StringBuilder();
    StringBuilder colours = new StringBuilder();
    int board = 0;
    for (int row = 0; row < ROWS; row++) {
      List<Double> joints = joints(row);
      for (int i = 0; i + 1 < joints.size(); i++, board++) {
        corners(points, row, joints.get(i), joints.get(i + 1));
        int p = 4 * board;
        faces.append(String.format(Locale.ROOT, "%d %d %d %d -1 ", p, p + 1, p + 2, p + 3));
        // Along a row the colours step by 1; the square keeps neighbouring rows out of step.
        colours.append((row * 5 + i + row * row) % 6).append(' ');
      }
    }
    out.open("Shape", "DEF", "WoodenFloor");
    out.material("specularColor", "0.12 0.12 0.12", "shininess", "0.2");
    out.open("IndexedFaceSet", "colorPerVertex", "false", "solid", "false");
    out.ownLine().numbers("coordIndex", faces.toString().strip());
    out.ownLine().numbers("colorIndex", colours.toString().strip());
    out.empty("Coordinate", "point", points.toString().strip());
    out.empty("Color", "color", BROWNS).close().close();
  }

  /** Where a row's boards meet: every third row alike. */
  private static List<Double> joints(int row) {
    List<Double> joints = new ArrayList<>(List.of(0.0));
    for (double z = BOARD * (1 + row * 7 % 5) / 5; z < DEPTH - 0.05; z += BOARD) {
      joints.add(z);
    }
    joints.add(DEPTH);
    return joints;
  }

  private static void corners(StringBuilder points, int row, double near, double far) {
    double left = WIDTH * row / ROWS;
    double right = WIDTH * (row + 1) / ROWS;
    points.append(
        String.format(
            Locale.ROOT,
            "%.2f 0 %.2f %.2f 0 %.2f %.2f 0 %.2f %.2f 0 %.2f ",
            left,
            near,
            left,
            far,
            right,
            far,
            right,
            near));
  }
}
