package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4f;
import org.selectiverenderer.runtime.instance.TextureUnit;

/** Computes the matrices by which a shader multiplies texture coordinates. */
final class DetailMatrices {
  private DetailMatrices() {}

  /**
   * @param bounds of the mesh: min x, y, z, max x, y, z
   * @return sixteen numbers per unit
   */
  static float[] of(List<TextureUnit> units, float[] bounds) {
    float[] all = new float[16 * units.size()];
    for (int i = 0; i < units.size(); i++) {
      TextureUnit unit = units.get(i);
      Matrix4f matrix = new Matrix4f().set(unit.matrix());
      if (unit.set() == TextureUnit.BOUNDS) {
        boolean cube = unit.source().cube();
        matrix.mul(cube ? aroundMiddle(bounds) : through(bounds));
      }
      matrix.get(all, 16 * i);
    }
    return all;
  }

  /** Returns the map to coordinates from 0 to 1 along each side of the bounding box. */
  private static Matrix4f through(float[] b) {
    return new Matrix4f()
        .scale(share(b[3] - b[0]), share(b[4] - b[1]), share(b[5] - b[2]))
        .translate(-b[0], -b[1], -b[2]);
  }

  private static float share(float side) {
    return side > 0 ? 1 / side : 0;
  }

  /** Returns the map to directions from the centre of the bounding box. */
  private static Matrix4f aroundMiddle(float[] b) {
    return new Matrix4f().translation(-(b[0] + b[3]) / 2, -(b[1] + b[4]) / 2, -(b[2] + b[5]) / 2);
  }
}
