package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.movie.Film;

/**
 * A texture image with its sampling.
 *
 * @param repeatS whether the image repeats horizontally, else its edge extends
 * @param repeatT whether it repeats vertically
 * @param sampling what TextureProperties says, which goes before the two; or null
 */
public record Texture(Image image, boolean repeatS, boolean repeatT, @Nullable Sampling sampling)
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
   * A picture, decoded, or several of one size. Compare by identity.
   *
   * @param layers pictures, one after the other in {@code rgba}: the slices of a 3D texture, the
   *     faces of a cube in the order of {@link CubeTexture}; 1 for a plain picture
   * @param components 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA as X3D counts them (18.2.1): with 1
   *     or 2 the material's diffuse colour tints, with 3 or 4 the image's colour replaces it
   * @param rgba width * height * layers pixels of four bytes r, g, b, a; the first row is the
   *     lowest
   * @param film whose pictures are seen in its place, of which it is the first; or null
   */
  public record Image(
      int width, int height, int layers, int components, byte[] rgba, @Nullable Film film) {
    /** One that stands still. */
    public Image(int width, int height, int layers, int components, byte[] rgba) {
      this(width, height, layers, components, rgba, null);
    }

    /** A plain picture. */
    public Image(int width, int height, int components, byte[] rgba) {
      this(width, height, 1, components, rgba);
    }

    /** The same with another film. */
    public Image with(@Nullable Film other) {
      return new Image(width, height, layers, components, rgba, other);
    }

    /** Whether the image has an alpha channel. */
    public boolean translucent() {
      return components == 2 || components == 4;
    }
  }
}
