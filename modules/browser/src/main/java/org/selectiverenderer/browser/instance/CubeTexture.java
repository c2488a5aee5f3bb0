package org.selectiverenderer.browser.instance;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A cube map: six square images (X3D 4.0, clause 34).
 *
 * @param faces the faces front (-Z), back (+Z), left (-X), right (+X), top (+Y), bottom (-Y), each
 *     as seen from the centre and upright as the images of a Background
 */
public record CubeTexture(List<Face> faces, @Nullable TextureSampler sampling)
    implements TextureSource {
  /** The number of faces. */
  public static final int FACES = 6;

  /**
   * A face of the cube.
   *
   * @param layer the layer of the image that holds the face
   */
  public record Face(Texture.Image image, int layer) {}

  @Override
  public boolean cube() {
    return true;
  }

  @Override
  public int components() {
    return faces.get(0).image().components();
  }
}
