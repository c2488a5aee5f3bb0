package org.selectiverenderer.render.draw;

import org.joml.Matrix4d;
import org.selectiverenderer.browser.camera.Camera;

/**
 * A rectangle of a picture's pixels, from the lower left.
 *
 * @param x of the first column
 * @param y of the first row
 */
public record PixelRectangle(int x, int y, int width, int height) {
  /** Returns the whole viewport of a camera. */
  public static PixelRectangle of(Camera camera) {
    return new PixelRectangle(camera.x(), camera.y(), camera.width(), camera.height());
  }

  /** Returns the number of its pixels. */
  public long area() {
    return (long) width * height;
  }

  /** Returns the smallest rectangle that holds this one and another. */
  public PixelRectangle union(PixelRectangle other) {
    int left = Math.min(x, other.x);
    int bottom = Math.min(y, other.y);
    int right = Math.max(x + width, other.x + other.width);
    int top = Math.max(y + height, other.y + other.height);
    return new PixelRectangle(left, bottom, right - left, top - bottom);
  }

  /**
   * Returns a rectangle with a border around it, of whole squares of a grid; it may reach beyond
   * the picture.
   */
  public PixelRectangle enlarged(int border, int grid) {
    int left = Math.floorDiv(x - border, grid) * grid;
    int bottom = Math.floorDiv(y - border, grid) * grid;
    int right = -Math.floorDiv(-(x + width + border), grid) * grid;
    int top = -Math.floorDiv(-(y + height + border), grid) * grid;
    return new PixelRectangle(left, bottom, right - left, top - bottom);
  }

  /**
   * Returns a camera that sees only this part of what another sees, at the same scale: for culling.
   */
  public Camera within(Camera camera) {
    int[] viewport = {camera.x(), camera.y(), camera.width(), camera.height()};
    Matrix4d part =
        new Matrix4d()
            .pick(x + width / 2.0, y + height / 2.0, width, height, viewport)
            .mul(camera.projection());
    return new Camera(camera.view(), part, x, y, width, height);
  }
}
