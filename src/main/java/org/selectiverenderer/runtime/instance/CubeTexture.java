package org.selectiverenderer.runtime.instance;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Six square images around a place (X3D 4.0, 34).
 *
 * @param faces front (-Z), back (+Z), left (-X), right (+X), top (+Y), bottom (-Y), each as seen
 *     from the middle, upright as the pictures of a Background are
 */
public record CubeTexture(List<Face> faces, @Nullable Sampling sampling) implements TextureSource {
  /** How many faces there are. */
  public static final int FACES = 6;

  /**
   * One of them.
   *
   * @param layer of the image
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
