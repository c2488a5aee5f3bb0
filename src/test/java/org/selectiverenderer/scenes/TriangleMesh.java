package org.selectiverenderer.scenes;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

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
        .map(p -> number(p[0]) + " " + number(p[1]) + " " + number(p[2]))
        .collect(Collectors.joining(" "));
  }

  /** The value of {@code IndexedFaceSet.coordIndex}. */
  String coordIndexText() {
    return triangles.stream()
        .map(t -> t[0] + " " + t[1] + " " + t[2] + " -1")
        .collect(Collectors.joining(" "));
  }

  /** Four decimals at most, without the zeros that say nothing: {@code 0.153}, {@code 0}. */
  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.4f", value).replaceFirst("\\.?0+$", "");
    return text.equals("-0") ? "0" : text;
  }
}
