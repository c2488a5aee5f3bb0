package org.selectiverenderer.scenes;

import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.DecimalFormatter;

/**
 * Points and triangles as a recipe makes them.
 *
 * @param points {@code x y z} in metres
 * @param triangles indices of {@code points}, counter-clockwise seen from outside
 */
record TriangleMesh(List<double[]> points, List<int[]> triangles) {

  /** The value of {@code Coordinate.point}, to tenths of a millimetre. */
  String pointText() {
    return points.stream()
        .map(
            p ->
                DecimalFormatter.rounded(p[0], 4)
                    + " "
                    + DecimalFormatter.rounded(p[1], 4)
                    + " "
                    + DecimalFormatter.rounded(p[2], 4))
        .collect(Collectors.joining(" "));
  }

  /** The value of {@code IndexedFaceSet.coordIndex}. */
  String coordIndexText() {
    return triangles.stream()
        .map(t -> t[0] + " " + t[1] + " " + t[2] + " -1")
        .collect(Collectors.joining(" "));
  }
}
