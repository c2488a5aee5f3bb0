package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.movie.MoviePlayback;

/**
 * A texture image with its sampler settings.
 *
 * @param repeatS whether the image repeats horizontally; otherwise its edge extends
 * @param repeatT whether it repeats vertically
 * @param sampling the TextureProperties, which override {@code repeatS} and {@code repeatT}; or
 *     null
 */
public record Texture(
    Image image, boolean repeatS, boolean repeatT, @Nullable TextureSampler sampling)
    implements TextureSource {

  /** A texture without TextureProperties. */
  public Texture(Image image, boolean repeatS, boolean repeatT) {
    this(image, repeatS, repeatT, null);
  }

  @Override
  public int components() {
    return image.components();
  }

  /**
   * A decoded image, or several layers of one size. Compared by identity.
   *
   * @param layers the number of layers, stored one after the other in {@code rgba}: the slices of a
   *     3D texture, or the faces of a cube map in the order of {@link CubeTexture}; 1 for a plain
   *     image
   * @param components 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA as X3D counts them (18.2.1): with 1
   *     or 2 the material's diffuse colour tints, with 3 or 4 the image's colour replaces it
   * @param rgba width * height * layers pixels of four bytes r, g, b, a; the first row is the
   *     lowest
   * @param film the movie whose frames replace this image, which is its first frame; or null
   */
  public record Image(
      int width,
      int height,
      int layers,
      int components,
      byte[] rgba,
      @Nullable MoviePlayback film) {
    /** Makes a still image. */
    public Image(int width, int height, int layers, int components, byte[] rgba) {
      this(width, height, layers, components, rgba, null);
    }

    /** Makes a still image of one layer. */
    public Image(int width, int height, int components, byte[] rgba) {
      this(width, height, 1, components, rgba);
    }

    /** Returns the same image with another movie. */
    public Image with(@Nullable MoviePlayback other) {
      return new Image(width, height, layers, components, rgba, other);
    }

    /** Returns whether the image has an alpha channel. */
    public boolean translucent() {
      return components == 2 || components == 4;
    }
  }
}
