package org.selectiverenderer.browser.instance;

import org.joml.Matrix4dc;
import org.selectiverenderer.browser.scene.Node;

/**
 * The fog of a Fog or LocalFog node (X3D 4.0, 24.3.2).
 *
 * @param exponential whether the fog grows exponentially with distance, else linearly
 * @param range the visibility range, beyond which only fog is visible, in world units; 0 for no fog
 */
public record Fog(boolean exponential, float red, float green, float blue, double range) {
  /** No fog. */
  public static final Fog NONE = new Fog(false, 0, 0, 0, 0);

  /**
   * Reads a Fog or LocalFog node.
   *
   * @param place the matrix from the node's coordinates, in which its range is given, to the world
   */
  public static Fog read(Node node, Matrix4dc place) {
    float[] color = node.floats("color");
    double range = node.number("visibilityRange") * Math.cbrt(Math.abs(place.determinant3x3()));
    return range > 0 && Double.isFinite(range)
        ? new Fog(node.string("fogType").equals("EXPONENTIAL"), color[0], color[1], color[2], range)
        : NONE;
  }

  public boolean isClear() {
    return range <= 0;
  }
}
