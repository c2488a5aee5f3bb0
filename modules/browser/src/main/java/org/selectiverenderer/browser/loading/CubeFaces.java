package org.selectiverenderer.browser.loading;

import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Converts cube maps of files to the order and directions of a {@link CubeTexture}. Files hold the
 * faces in the order +X, -X, +Y, -Y, +Z, -Z, as GPUs do, as seen from outside.
 */
final class CubeFaces {
  /** For each face of a {@link CubeTexture} the index of the file's face. */
  private static final int[] FACES = {5, 4, 1, 0, 2, 3};

  /** For each face of a {@link CubeTexture}: its centre, and the vectors to the right and up. */
  private static final int[][] AXES = {
    {0, 0, -1, 1, 0, 0, 0, 1, 0},
    {0, 0, 1, -1, 0, 0, 0, 1, 0},
    {-1, 0, 0, 0, 0, -1, 0, 1, 0},
    {1, 0, 0, 0, 0, 1, 0, 1, 0},
    {0, 1, 0, 1, 0, 0, 0, 0, 1},
    {0, -1, 0, 1, 0, 0, 0, 0, -1}
  };

  private CubeFaces() {}

  /** Returns the layer for a face of the file. */
  static int layer(int face) {
    for (int i = 0; i < FACES.length; i++) {
      if (FACES[i] == face) {
        return i;
      }
    }
    throw new IllegalArgumentException("a cube has no face " + face);
  }

  /**
   * Turns a face of a file in place so that it is as seen from inside: the side faces are mirrored,
   * and the top and bottom faces are turned upside down.
   *
   * @param from the first byte of the face's pixels
   * @param face the index of the file's face
   */
  static void asSeenFromInside(byte[] rgba, int from, int width, int height, int face) {
    boolean side = face != 2 && face != 3;
    for (int y = 0; y < (side ? height : height / 2); y++) {
      for (int x = 0; x < (side ? width / 2 : width); x++) {
        int a = from + 4 * (y * width + x);
        int b = from + 4 * (side ? y * width + width - 1 - x : (height - 1 - y) * width + x);
        for (int c = 0; c < 4; c++) {
          byte kept = rgba[a + c];
          rgba[a + c] = rgba[b + c];
          rgba[b + c] = kept;
        }
      }
    }
  }

  /** Returns whether an image has the shape of a panorama: twice as wide as high. */
  static boolean panorama(Texture.Image image) {
    return image.layers() == 1 && image.height() > 1 && image.width() == 2 * image.height();
  }

  /**
   * Returns the cube map of a panorama, whose rows are latitudes and whose columns are longitudes
   * (equirectangular projection): the middle is the front (-Z), to the right of it is +X, the upper
   * edge is +Y. Each face is half as high as the panorama; a texel takes the nearest pixel.
   */
  static Texture.Image ofPanorama(Texture.Image panorama) {
    int size = panorama.height() / 2;
    byte[] rgba = new byte[CubeTexture.FACES * size * size * 4];
    int to = 0;
    for (int[] axes : AXES) {
      for (int row = 0; row < size; row++) {
        for (int column = 0; column < size; column++, to += 4) {
          double u = (2 * column + 1.0) / size - 1;
          double v = (2 * row + 1.0) / size - 1;
          double x = axes[0] + u * axes[3] + v * axes[6];
          double y = axes[1] + u * axes[4] + v * axes[7];
          double z = axes[2] + u * axes[5] + v * axes[8];
          double right = Math.atan2(x, -z) / (2 * Math.PI) + 0.5;
          double up = Math.atan2(y, Math.hypot(x, z)) / Math.PI + 0.5;
          int px = Math.min(panorama.width() - 1, (int) (right * panorama.width()));
          int py = Math.min(panorama.height() - 1, (int) (up * panorama.height()));
          System.arraycopy(panorama.rgba(), 4 * (py * panorama.width() + px), rgba, to, 4);
        }
      }
    }
    return new Texture.Image(size, size, CubeTexture.FACES, panorama.components(), rgba);
  }
}
