package org.selectiverenderer.runtime.instance;

/**
 * A texture image with its sampling.
 *
 * @param repeatS whether the image repeats horizontally, else its edge extends
 * @param repeatT whether it repeats vertically
 */
public record Texture(Image image, boolean repeatS, boolean repeatT) {

  /**
   * A picture, decoded. Compare by identity.
   *
   * @param components 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA as X3D counts them (18.2.1): with 1
   *     or 2 the material's diffuse colour tints, with 3 or 4 the image's colour replaces it
   * @param rgba width * height pixels of four bytes r, g, b, a; the first row is the lowest
   */
  public record Image(int width, int height, int components, byte[] rgba) {
    /** Whether the image has an alpha channel. */
    public boolean translucent() {
      return components == 2 || components == 4;
    }
  }
}
