package org.selectiverenderer.runtime.instance;

import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Fog as it is seen: a Fog or LocalFog node (X3D 4.0, 24.3.2).
 *
 * @param exponential whether it thickens exponentially, else linearly
 * @param range where nothing but fog is seen, in the world's unit; 0 for no fog
 */
public record Fog(boolean exponential, float red, float green, float blue, double range) {
  /** No fog at all. */
  public static final Fog NONE = new Fog(false, 0, 0, 0, 0);

  /**
   * Reads a node.
   *
   * @param place from the node's coordinates, in which its range is given, to the world
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
