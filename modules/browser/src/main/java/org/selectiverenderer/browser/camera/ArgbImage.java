package org.selectiverenderer.browser.camera;

/** An image in memory, immutable. A renderer may cache the texture that it makes of the object. */
public final class ArgbImage {
  private final int width;
  private final int height;
  private final int[] colors;

  /**
   * @param colors 0xAARRGGBB, row by row from the top; not to be changed afterwards
   */
  public ArgbImage(int width, int height, int[] colors) {
    if (width < 1 || height < 1 || colors.length != width * height) {
      throw new IllegalArgumentException(
          "%d colours for %d by %d pixels".formatted(colors.length, width, height));
    }
    this.width = width;
    this.height = height;
    this.colors = colors;
  }

  /** Returns the width in pixels. */
  public int width() {
    return width;
  }

  /** Returns the height in pixels. */
  public int height() {
    return height;
  }

  /** Returns a pixel as 0xAARRGGBB. */
  public int color(int x, int y) {
    return colors[y * width + x];
  }
}
