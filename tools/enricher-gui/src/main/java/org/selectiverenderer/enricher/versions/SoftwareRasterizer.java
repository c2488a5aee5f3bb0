package org.selectiverenderer.enricher.versions;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * A software rasterizer for meshes: it needs no graphics card and draws some ten thousand polygons
 * in milliseconds. Draws solids with a depth buffer and light from the viewer, or the edges of all
 * polygons as in thesis Fig 39. Parallel projection.
 */
final class SoftwareRasterizer {
  private static final double FIT = 0.95;
  private final int width;
  private final int height;
  private final int[] pixels;
  private final float[] depth;
  private final float[] p = new float[9];

  /**
   * @param pixels 0xRRGGBB, row by row from the top; painted over
   */
  SoftwareRasterizer(int[] pixels, int width, int height) {
    this.pixels = pixels;
    this.width = width;
    this.height = height;
    this.depth = new float[pixels.length];
  }

  /** Draws the faces of a mesh. */
  void solid(ColoredMesh shape, BoundingSphere frame, TurntableCamera turntable) {
    Arrays.fill(depth, Float.NEGATIVE_INFINITY);
    double[] rotation = turntable.rotation();
    for (int t = 0; t < shape.polygons(); t++) {
      project(shape.corners(), 9 * t, frame, rotation, turntable.zoom());
      fill(shade(shape.colors()[t]));
    }
  }

  /** Draws the edges of a mesh. */
  void wires(ColoredMesh shape, BoundingSphere frame, TurntableCamera turntable, int color) {
    double[] rotation = turntable.rotation();
    for (int t = 0; t < shape.polygons(); t++) {
      project(shape.corners(), 9 * t, frame, rotation, turntable.zoom());
      line(p[0], p[1], p[3], p[4], color);
      line(p[3], p[4], p[6], p[7], color);
      line(p[6], p[7], p[0], p[1], color);
    }
  }

  private void project(float[] corners, int at, BoundingSphere frame, double[] r, double zoom) {
    double scale = FIT * zoom * Math.min(width, height) / 2 / frame.radius();
    for (int c = 0; c < 3; c++) {
      double x = corners[at + 3 * c] - frame.x();
      double y = corners[at + 3 * c + 1] - frame.y();
      double z = corners[at + 3 * c + 2] - frame.z();
      p[3 * c] = (float) (width / 2.0 + scale * (r[0] * x + r[1] * y + r[2] * z));
      p[3 * c + 1] = (float) (height / 2.0 - scale * (r[3] * x + r[4] * y + r[5] * z));
      p[3 * c + 2] = (float) (scale * (r[6] * x + r[7] * y + r[8] * z));
    }
  }

  /**
   * Shades the current face: brighter the more it faces the viewer; back faces are lit like front
   * ones.
   */
  private int shade(int color) {
    double[] n = new double[3];
    TriangleMath.cross(
        p[3] - p[0], p[4] - p[1], p[5] - p[2], p[6] - p[0], p[7] - p[1], p[8] - p[2], n);
    double length = TriangleMath.length(n);
    // The light is a little to the left of and above the viewer, so that faces differ.
    double facing = length == 0 ? 0 : Math.abs(-0.35 * n[0] - 0.45 * n[1] + 0.82 * n[2]) / length;
    double light = 0.3 + 0.7 * facing;
    int red = (int) ((color >> 16 & 0xFF) * light);
    int green = (int) ((color >> 8 & 0xFF) * light);
    int blue = (int) ((color & 0xFF) * light);
    return red << 16 | green << 8 | blue;
  }

  private void fill(int color) {
    int left = Math.max(0, (int) Math.floor(Math.min(p[0], Math.min(p[3], p[6]))));
    int right = Math.min(width - 1, (int) Math.ceil(Math.max(p[0], Math.max(p[3], p[6]))));
    int top = Math.max(0, (int) Math.floor(Math.min(p[1], Math.min(p[4], p[7]))));
    int bottom = Math.min(height - 1, (int) Math.ceil(Math.max(p[1], Math.max(p[4], p[7]))));
    float area = (p[3] - p[0]) * (p[7] - p[1]) - (p[6] - p[0]) * (p[4] - p[1]);
    if (area == 0) {
      return;
    }
    for (int y = top; y <= bottom; y++) {
      for (int x = left; x <= right; x++) {
        float px = x + 0.5f;
        float py = y + 0.5f;
        float a = ((p[3] - px) * (p[7] - py) - (p[6] - px) * (p[4] - py)) / area;
        float b = ((p[6] - px) * (p[1] - py) - (p[0] - px) * (p[7] - py)) / area;
        float c = 1 - a - b;
        int at = y * width + x;
        float z = a * p[2] + b * p[5] + c * p[8];
        if (a >= 0 && b >= 0 && c >= 0 && z > depth[at]) {
          depth[at] = z;
          pixels[at] = color;
        }
      }
    }
  }

  private void line(float x0, float y0, float x1, float y1, int color) {
    int steps = (int) Math.ceil(Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)));
    if (steps > 4 * (width + height)) {
      steps = 4 * (width + height); // most of such a long line is outside of the picture
    }
    for (int i = 0; i <= steps; i++) {
      float share = steps == 0 ? 0 : (float) i / steps;
      int x = (int) Math.floor(x0 + share * (x1 - x0));
      int y = (int) Math.floor(y0 + share * (y1 - y0));
      if (x >= 0 && x < width && y >= 0 && y < height) {
        pixels[y * width + x] = color;
      }
    }
  }
}
