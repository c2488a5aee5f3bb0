package org.selectiverenderer.geometry.font;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/** Reads simple and composite glyph outlines of a TrueType font as polygons in font units. */
final class GlyphOutlineReader {
  /** The maximum nesting of composite glyphs, which stops cyclic references. */
  private static final int DEPTH = 8;

  private static final int ON_CURVE = 1;
  private static final int X_SHORT = 2;
  private static final int Y_SHORT = 4;
  private static final int REPEAT = 8;
  private static final int X_SAME_OR_POSITIVE = 16;
  private static final int Y_SAME_OR_POSITIVE = 32;

  private static final int WORDS = 1;
  private static final int OFFSETS = 2;
  private static final int ONE_SCALE = 8;
  private static final int MORE = 32;
  private static final int TWO_SCALES = 64;
  private static final int MATRIX = 128;

  private final TrueTypeFile file;
  private final List<float[]> contours = new ArrayList<>();

  private GlyphOutlineReader(TrueTypeFile file) {
    this.file = file;
  }

  /** Returns the contours of a glyph with flattened curves: x, y per point, not closed. */
  static List<float[]> of(TrueTypeFile file, int glyph) {
    GlyphOutlineReader reader = new GlyphOutlineReader(file);
    reader.read(glyph, new float[] {1, 0, 0, 1, 0, 0}, 0);
    return reader.contours;
  }

  /** Reads a glyph; {@code m} is the transform x' = m0 x + m2 y + m4, y' = m1 x + m3 y + m5. */
  private void read(int glyph, float[] m, int depth) {
    ByteBuffer data = file.outline(glyph);
    if (data.remaining() == 0) {
      return;
    }
    int count = data.getShort();
    data.position(10);
    if (count >= 0) {
      readSimple(data, count, m);
    } else if (depth < DEPTH) {
      readComposite(data, m, depth);
    }
  }

  private void readSimple(ByteBuffer data, int count, float[] m) {
    int[] ends = new int[count];
    for (int i = 0; i < count; i++) {
      ends[i] = data.getShort() & 0xFFFF;
    }
    int points = count == 0 ? 0 : ends[count - 1] + 1;
    int instructions = data.getShort() & 0xFFFF;
    data.position(data.position() + instructions);
    byte[] flags = new byte[points];
    for (int i = 0; i < points; i++) {
      byte flag = data.get();
      flags[i] = flag;
      for (int repeat = (flag & REPEAT) != 0 ? data.get() & 0xFF : 0; repeat > 0; repeat--) {
        flags[++i] = flag;
      }
    }
    float[] x = coordinates(data, flags, X_SHORT, X_SAME_OR_POSITIVE);
    float[] y = coordinates(data, flags, Y_SHORT, Y_SAME_OR_POSITIVE);
    for (int i = 0; i < points; i++) {
      float tx = m[0] * x[i] + m[2] * y[i] + m[4];
      y[i] = m[1] * x[i] + m[3] * y[i] + m[5];
      x[i] = tx;
    }
    boolean mirrored = m[0] * m[3] - m[1] * m[2] < 0;
    int from = 0;
    for (int end : ends) {
      if (end - from >= 2) {
        float[] contour = BezierFlattener.flatten(x, y, flags, from, end + 1);
        contours.add(mirrored ? reversed(contour) : contour);
      }
      from = end + 1;
    }
  }

  private static float[] coordinates(ByteBuffer data, byte[] flags, int isShort, int same) {
    float[] values = new float[flags.length];
    int value = 0;
    for (int i = 0; i < flags.length; i++) {
      if ((flags[i] & isShort) != 0) {
        int step = data.get() & 0xFF;
        value += (flags[i] & same) != 0 ? step : -step;
      } else if ((flags[i] & same) == 0) {
        value += data.getShort();
      }
      values[i] = value;
    }
    return values;
  }

  /** Returns whether a point is on the curve rather than an off-curve control point. */
  static boolean onCurve(byte flag) {
    return (flag & ON_CURVE) != 0;
  }

  private void readComposite(ByteBuffer data, float[] m, int depth) {
    int flags;
    do {
      flags = data.getShort();
      int glyph = data.getShort() & 0xFFFF;
      float dx = (flags & WORDS) != 0 ? data.getShort() : data.get();
      float dy = (flags & WORDS) != 0 ? data.getShort() : data.get();
      if ((flags & OFFSETS) == 0) {
        // placement by matching points does not occur in the bundled fonts
        dx = 0;
        dy = 0;
      }
      float[] c = {1, 0, 0, 1};
      if ((flags & ONE_SCALE) != 0) {
        c[0] = fraction(data);
        c[3] = c[0];
      } else if ((flags & TWO_SCALES) != 0) {
        c[0] = fraction(data);
        c[3] = fraction(data);
      } else if ((flags & MATRIX) != 0) {
        for (int i = 0; i < 4; i++) {
          c[i] = fraction(data);
        }
      }
      float[] part = {
        m[0] * c[0] + m[2] * c[1],
        m[1] * c[0] + m[3] * c[1],
        m[0] * c[2] + m[2] * c[3],
        m[1] * c[2] + m[3] * c[3],
        m[0] * dx + m[2] * dy + m[4],
        m[1] * dx + m[3] * dy + m[5]
      };
      read(glyph, part, depth + 1);
    } while ((flags & MORE) != 0);
  }

  /** Reads an F2DOT14 fixed-point number, with 14 fractional bits. */
  private static float fraction(ByteBuffer data) {
    return data.getShort() / 16384f;
  }

  private static float[] reversed(float[] contour) {
    float[] reversed = new float[contour.length];
    for (int i = 0; i < contour.length; i += 2) {
      reversed[i] = contour[contour.length - 2 - i];
      reversed[i + 1] = contour[contour.length - 1 - i];
    }
    return reversed;
  }
}
