package org.selectiverenderer.models.gltf;

import java.util.Arrays;

/** Converts the drawing modes of glTF (3.7.2.1) to lists of triangles and of line ends. */
final class PrimitiveIndices {
  static final int POINTS = 0;
  static final int LINES = 1;
  static final int LINE_LOOP = 2;
  static final int LINE_STRIP = 3;
  static final int TRIANGLES = 4;
  static final int TRIANGLE_STRIP = 5;
  static final int TRIANGLE_FAN = 6;

  private PrimitiveIndices() {}

  /** Returns 0, 1, 2 and so on, which a primitive without indices has. */
  static int[] sequence(int count) {
    int[] indices = new int[count];
    Arrays.setAll(indices, i -> i);
    return indices;
  }

  /** Returns three indices for each triangle. */
  static int[] triangles(int mode, int[] indices) {
    if (mode == TRIANGLES) {
      return Arrays.copyOf(indices, indices.length / 3 * 3);
    }
    int count = Math.max(0, indices.length - 2);
    int[] triangles = new int[Math.multiplyExact(3, count)];
    for (int i = 0; i < count; i++) {
      // every second triangle of a strip is listed the other way round
      boolean turned = mode == TRIANGLE_STRIP && i % 2 == 1;
      triangles[3 * i] = mode == TRIANGLE_FAN ? indices[0] : indices[turned ? i + 1 : i];
      triangles[3 * i + 1] = indices[turned ? i : i + 1];
      triangles[3 * i + 2] = indices[i + 2];
    }
    return triangles;
  }

  /** Returns the coordIndex of an IndexedLineSet, in which -1 ends each line. */
  static int[] lines(int mode, int[] indices) {
    if (mode != LINES) {
      boolean loop = mode == LINE_LOOP && indices.length > 0;
      int[] line = Arrays.copyOf(indices, indices.length + (loop ? 2 : 1));
      if (loop) {
        line[indices.length] = indices[0];
      }
      line[line.length - 1] = -1;
      return line;
    }
    int[] lines = new int[indices.length / 2 * 3];
    for (int i = 0; i < indices.length / 2; i++) {
      lines[3 * i] = indices[2 * i];
      lines[3 * i + 1] = indices[2 * i + 1];
      lines[3 * i + 2] = -1;
    }
    return lines;
  }
}
