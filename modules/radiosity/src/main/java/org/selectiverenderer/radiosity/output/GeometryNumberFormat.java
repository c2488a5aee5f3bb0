package org.selectiverenderer.radiosity.output;

import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.write.TupleListBuilder;

/** Formats the numbers of a lit shape's geometry as text with as few characters as possible. */
final class GeometryNumberFormat {
  private static final int PER_LINE = 24;
  private static final int MOST_DECIMALS = 9;

  private GeometryNumberFormat() {}

  static TupleListBuilder lines() {
    return TupleListBuilder.perLine(PER_LINE);
  }

  /** Returns the {@code index} field of an IndexedTriangleStripSet. */
  static StringBuilder strips(int[] index) {
    TupleListBuilder strips = lines();
    for (int[] strip : TriangleStripBuilder.of(index)) {
      for (int vertex : strip) {
        strips.next().append(vertex);
      }
      strips.text().append(" -1");
    }
    return strips.text();
  }

  /**
   * Returns the number of decimals of a mesh's coordinates.
   *
   * @param least least number of steps across the shape's extent
   */
  static int decimals(Mesh mesh, double least) {
    float[] b = mesh.bounds();
    double extent = Math.max(b[3] - b[0], Math.max(b[4] - b[1], b[5] - b[2]));
    int digits = 0;
    for (double size = extent; size < least && size > 0 && digits < MOST_DECIMALS; size *= 10) {
      digits++;
    }
    return Math.max(1, digits);
  }

  /** Appends numbers with blanks between them. */
  static void tuple(StringBuilder text, double[] values, int decimals) {
    for (int i = 0; i < values.length; i++) {
      text.append(i == 0 ? "" : " ");
      number(text, values[i], decimals);
    }
  }

  /**
   * Appends a number without the zero before its decimal point, which the encoding does not
   * require.
   */
  static void number(StringBuilder text, double value, int decimals) {
    int at = text.length();
    DecimalFormatter.appendRounded(text, value, decimals);
    int digit = text.charAt(at) == '-' ? at + 1 : at;
    if (text.length() > digit + 1 && text.charAt(digit) == '0' && text.charAt(digit + 1) == '.') {
      text.deleteCharAt(digit);
    }
  }
}
