package org.selectiverenderer.chart;

import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.geometry.font.Glyph;

/**
 * Draws to an RGB raster image. Glyphs are filled triangle by triangle and antialiased by the
 * coverage of each pixel, which is exact horizontally and sampled on eight lines per pixel
 * vertically. AWT is not used, since it needs fonts of the machine and may look for a display.
 */
final class RasterCanvas implements ChartCanvas {
  private static final int LINES = 8;

  private final int width;
  private final int height;
  private final byte[] rgb;

  RasterCanvas(int width, int height) {
    this.width = width;
    this.height = height;
    rgb = new byte[3 * width * height];
  }

  /**
   * Fills a rectangle. Edges are rounded to whole pixels, so that bars are crisp; a rectangle is at
   * least one pixel thick.
   */
  @Override
  public void rectangle(double x, double y, double w, double h, ChartColour colour) {
    int left = clamp(Math.round(x), width);
    int top = clamp(Math.round(y), height);
    int right = clamp(Math.max(Math.round(x + w), left + (w > 0 ? 1 : 0)), width);
    int bottom = clamp(Math.max(Math.round(y + h), top + (h > 0 ? 1 : 0)), height);
    for (int row = top; row < bottom; row++) {
      for (int column = left; column < right; column++) {
        int pixel = 3 * (row * width + column);
        for (int shift = 16; shift >= 0; shift -= 8) {
          rgb[pixel++] = (byte) (colour.rgb() >> shift);
        }
      }
    }
  }

  private static int clamp(long value, int limit) {
    return (int) Math.max(0, Math.min(value, limit));
  }

  @Override
  public void text(String text, double x, double y, SizedFont lettering, ChartColour colour) {
    double pen = x;
    for (int character : text.codePoints().toArray()) {
      Glyph glyph = lettering.font().glyph(character);
      fill(glyph, pen, y, lettering.size(), colour);
      pen += glyph.advance() * lettering.size();
    }
  }

  private void fill(Glyph glyph, double x, double y, double size, ChartColour colour) {
    int rows = (int) Math.ceil(2 * size) + 2;
    int columns = (int) Math.ceil(2 * size) + 2;
    int left = (int) Math.floor(x - size / 2);
    int top = (int) Math.floor(y - 1.5 * size);
    double[] coverage = new double[rows * columns];
    float[] p = glyph.points();
    int[] t = glyph.indices();
    for (int i = 0; i + 2 < t.length; i += 3) {
      double[] xs = new double[3];
      double[] ys = new double[3];
      for (int corner = 0; corner < 3; corner++) {
        xs[corner] = x + p[2 * t[i + corner]] * size - left;
        ys[corner] = y - p[2 * t[i + corner] + 1] * size - top;
      }
      cover(xs, ys, coverage, rows, columns);
    }
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        blend(left + column, top + row, colour, coverage[row * columns + column]);
      }
    }
  }

  private static void cover(double[] xs, double[] ys, double[] coverage, int rows, int columns) {
    double low = Math.min(ys[0], Math.min(ys[1], ys[2]));
    double high = Math.max(ys[0], Math.max(ys[1], ys[2]));
    int first = Math.max(0, (int) Math.ceil(low * LINES - 0.5));
    for (int line = first; line < rows * LINES && (line + 0.5) / LINES < high; line++) {
      double y = (line + 0.5) / LINES;
      double from = Double.POSITIVE_INFINITY;
      double to = Double.NEGATIVE_INFINITY;
      for (int a = 0, b = 2; a < 3; b = a++) {
        if (ys[a] <= y != ys[b] <= y) {
          double x = xs[a] + (y - ys[a]) / (ys[b] - ys[a]) * (xs[b] - xs[a]);
          from = Math.min(from, x);
          to = Math.max(to, x);
        }
      }
      for (int c = Math.max(0, (int) Math.floor(from)); c < columns && c < to; c++) {
        coverage[line / LINES * columns + c] +=
            Math.max(0, Math.min(to, c + 1) - Math.max(from, c)) / LINES;
      }
    }
  }

  private void blend(int x, int y, ChartColour colour, double coverage) {
    if (coverage <= 0 || x < 0 || y < 0 || x >= width || y >= height) {
      return;
    }
    double share = Math.min(1, coverage);
    int pixel = 3 * (y * width + x);
    for (int shift = 16; shift >= 0; shift -= 8) {
      double before = rgb[pixel] & 0xff;
      rgb[pixel++] = (byte) Math.round(before + share * ((colour.rgb() >> shift & 0xff) - before));
    }
  }

  /** Returns the picture as a PNG file. */
  byte[] png() {
    return PngEncoder.of(width, height, rgb);
  }
}
