package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Keyboard layouts, in units of a letter key's width. */
final class KeyboardLayout {
  /** The rows of letters from the back to the front, 15 units each; negative is a gap. */
  static final double[][] MAIN = {
    {1, -1, 1, 1, 1, 1, -0.5, 1, 1, 1, 1, -0.5, 1, 1, 1, 1},
    {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2},
    {1.5, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1.5},
    {1.75, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2.25},
    {2.25, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2.75},
    {1.5, 1.25, 1.25, 5.75, 1.25, 1.25, 1.25, 1.5}
  };

  /** The arrows, the block above them and the number pad, 7.75 units each. */
  static final double[][] RIGHT = {
    {-0.25, 1, 1, 1, -4.5},
    {-0.25, 1, 1, 1, -0.5, 1, 1, 1, 1},
    {-0.25, 1, 1, 1, -0.5, 1, 1, 1, 1},
    {-3.75, 1, 1, 1, 1},
    {-1.25, 1, -1.5, 1, 1, 1, 1},
    {-0.25, 1, 1, 1, -0.5, 2, 1, 1}
  };

  private KeyboardLayout() {}

  /**
   * @param pitch length of a unit, metres
   * @param depth distance from row to row, metres
   * @param key builds a key of a width in metres, standing at the origin
   * @return the keys with their left back corner at the origin
   */
  static TriangleMesh of(
      double[][] rows, double pitch, double depth, DoubleFunction<TriangleMesh> key) {
    List<TriangleMesh> all = new ArrayList<>();
    for (int row = 0; row < rows.length; row++) {
      double x = 0;
      for (double width : rows[row]) {
        if (width > 0) {
          all.add(key.apply(width * pitch).move((x + width / 2) * pitch, 0, (row + 0.5) * depth));
        }
        x += Math.abs(width);
      }
    }
    return TriangleMesh.of(all);
  }
}
