package org.selectiverenderer.runtime.camera;

/** A picture on a page. The same object is the same picture: what draws it may keep it. */
public final class Pixels {
  private final int width;
  private final int height;
  private final int[] colors;

  /**
   * @param colors 0xAARRGGBB, row by row from the uppermost; not written to any more
   */
  public Pixels(int width, int height, int[] colors) {
    if (width < 1 || height < 1 || colors.length != width * height) {
      throw new IllegalArgumentException(
          "%d colours for %d by %d pixels".formatted(colors.length, width, height));
    }
    this.width = width;
    this.height = height;
    this.colors = colors;
  }

  /** In pixels. */
  public int width() {
    return width;
  }

  /** In pixels. */
  public int height() {
    return height;
  }

  /** Four bytes of a pixel, 0xAARRGGBB. */
  public int color(int x, int y) {
    return colors[y * width + x];
  }
}
