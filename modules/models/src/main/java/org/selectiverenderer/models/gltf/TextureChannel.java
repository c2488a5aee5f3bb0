package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import org.selectiverenderer.models.scene.Numbers;

/**
 * A set of texture coordinates with its KHR_texture_transform. X3D finds the coordinates and the
 * transform of a texture by one name, so each pair of them is a channel.
 *
 * @param set the number of the glTF attribute TEXCOORD_n
 * @param offset u and v
 * @param rotation radians
 * @param scale u and v
 */
record TextureChannel(int set, List<Double> offset, double rotation, List<Double> scale) {
  private static final double NEAR = 1e-6;

  /** Returns the channel of a textureInfo of glTF. */
  static TextureChannel of(JsonNode info) {
    JsonNode transform = info.path("extensions").path("KHR_texture_transform");
    int set = Math.max(0, GltfFile.index(transform.has("texCoord") ? transform : info, "texCoord"));
    double[] offset = GltfFile.numbers(transform, "offset", 0, 0);
    double[] scale = GltfFile.numbers(transform, "scale", 1, 1);
    return new TextureChannel(
        set,
        List.of(offset[0], offset[1]),
        GltfFile.number(transform, "rotation", 0),
        List.of(scale[0], scale[1]));
  }

  boolean isTransformed() {
    return rotation != 0 || !offset.equals(List.of(0.0, 0.0)) || !scale.equals(List.of(1.0, 1.0));
  }

  /** Returns whether X3D's TextureTransform, which rotates before it scales, can express this. */
  boolean isExpressible() {
    double u = scale.get(0);
    double v = scale.get(1);
    boolean straight = Math.abs(Math.sin(rotation)) < NEAR || Math.abs(u - v) < NEAR;
    return straight && Math.abs(u) > NEAR && Math.abs(v) > NEAR;
  }

  /**
   * Returns the attributes of a TextureTransform. glTF's v goes down and X3D's t up, t = 1 - v, so
   * that s' = L (s, t) + k with L = scale · rotation and k the image of the origin; X3D adds its
   * translation first (X3D 4.0, 18.4.8), which therefore is the inverse of L applied to k.
   */
  String[] attributes() {
    double u = scale.get(0);
    double v = scale.get(1);
    double cos = Math.cos(rotation);
    double sin = Math.sin(rotation);
    double k0 = offset.get(0) + v * sin;
    double k1 = 1 - offset.get(1) - v * cos;
    // inverse of (rotation, then scale): by 1/scale, then rotated back
    double x = k0 / u;
    double y = k1 / v;
    return new String[] {
      "rotation", Numbers.of(rotation),
      "scale", Numbers.of(u, v),
      "translation", Numbers.of(x * cos + y * sin, -x * sin + y * cos)
    };
  }
}
