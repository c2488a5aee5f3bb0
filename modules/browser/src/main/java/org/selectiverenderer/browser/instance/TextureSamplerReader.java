package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.TextureSampler.Boundary;
import org.selectiverenderer.browser.instance.TextureSampler.Minify;
import org.selectiverenderer.browser.scene.Node;

/** Reads a TextureProperties node (X3D 4.0, 18.4.9). */
final class TextureSamplerReader {
  private TextureSamplerReader() {}

  /** Reads a texture's {@code textureProperties}; null if it has none. */
  static @Nullable TextureSampler of(Node texture) {
    if (texture.type().field("textureProperties").isEmpty()) {
      return null;
    }
    Node node = texture.node("textureProperties");
    if (node == null || !node.type().name().equals("TextureProperties")) {
      return null;
    }
    // Some scenes have fewer or more than four numbers, from the days when borderColor was an
    // SFColor.
    float[] c = Arrays.copyOf(node.floats("borderColor"), 4);
    return new TextureSampler(
        boundary(node.string("boundaryModeS")),
        boundary(node.string("boundaryModeT")),
        boundary(node.string("boundaryModeR")),
        new TextureSampler.Color(c[0], c[1], c[2], c[3]),
        Math.max(1, node.number("anisotropicDegree")),
        minify(node.string("minificationFilter")),
        linear(node.string("magnificationFilter")));
  }

  private static Boundary boundary(String mode) {
    return switch (mode) {
      case "CLAMP", "CLAMP_TO_EDGE" -> Boundary.EDGE;
      case "CLAMP_TO_BOUNDARY" -> Boundary.BORDER;
      case "MIRRORED_REPEAT" -> Boundary.MIRROR;
      default -> Boundary.REPEAT;
    };
  }

  /**
   * Returns the minification filter. FASTEST, which is every filter's default, leaves the choice to
   * the program, as DEFAULT and NICEST do (X3D 4.0, 18.4.9). They get mipmaps: an author who only
   * sets boundary modes does not want aliasing.
   */
  private static Minify minify(String filter) {
    return switch (filter) {
      case "NEAREST_PIXEL" -> Minify.NEAREST;
      case "AVG_PIXEL" -> Minify.LINEAR;
      case "NEAREST_PIXEL_NEAREST_MIPMAP" -> Minify.NEAREST_NEAREST;
      case "NEAREST_PIXEL_AVG_MIPMAP" -> Minify.NEAREST_LINEAR;
      case "AVG_PIXEL_NEAREST_MIPMAP" -> Minify.LINEAR_NEAREST;
      default -> Minify.LINEAR_LINEAR;
    };
  }

  private static boolean linear(String filter) {
    return !filter.equals("NEAREST_PIXEL");
  }
}
