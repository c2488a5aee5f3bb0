package org.selectiverenderer.browser.instance;

import java.util.List;
import org.joml.Matrix4f;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** The texture transforms of an Appearance (X3D 4.0, 18.4.10 and 33.4.5). */
final class TextureTransforms {
  private final List<? extends Node> nodes;
  private final boolean several;

  private TextureTransforms(List<? extends Node> nodes, boolean several) {
    this.nodes = nodes;
    this.several = several;
  }

  static TextureTransforms of(Node appearance) {
    Node node = appearance.node("textureTransform");
    if (node == null) {
      return new TextureTransforms(List.of(), false);
    }
    return node.type().name().equals("MultiTextureTransform")
        ? new TextureTransforms(node.nodes("textureTransform"), true)
        : new TextureTransforms(List.of(node), false);
  }

  /**
   * Returns the matrix of a MultiTexture's channel; null without a MultiTextureTransform (X3D 4.0,
   * 18.4.3).
   */
  @Nullable Matrix4f ofChannel(int channel) {
    return several ? matrix("", channel) : null;
  }

  /**
   * Returns the matrix of a texture.
   *
   * @param mapping the name by which the texture selects its transform, or ""
   * @param channel the texture's index in a MultiTexture, else 0
   * @return the matrix, or null if there is no transform
   */
  @Nullable Matrix4f matrix(String mapping, int channel) {
    if (!mapping.isEmpty()) {
      for (Node node : nodes) {
        if (mapping.equals(mapping(node))) {
          return matrix(node);
        }
      }
    }
    int place = several ? channel : 0;
    return place < nodes.size() ? matrix(nodes.get(place)) : null;
  }

  private static String mapping(Node node) {
    return node.type().field("mapping").isEmpty() ? "" : node.string("mapping");
  }

  private static @Nullable Matrix4f matrix(Node node) {
    return switch (node.type().name()) {
      case "TextureTransform" -> plane(node);
      case "TextureTransform3D" -> space(node);
      case "TextureTransformMatrix3D" -> new Matrix4f().set(node.floats("matrix"));
      default -> null;
    };
  }

  /** Tc' = -C S R C T Tc (X3D 4.0, 18.4.10). */
  private static Matrix4f plane(Node node) {
    float[] center = node.floats("center");
    float[] scale = node.floats("scale");
    float[] translation = node.floats("translation");
    return new Matrix4f()
        .translate(-center[0], -center[1], 0)
        .scale(scale[0], scale[1], 1)
        .rotateZ(node.number("rotation"))
        .translate(center[0], center[1], 0)
        .translate(translation[0], translation[1], 0);
  }

  /**
   * Returns the matrix of a TextureTransform3D: scale, rotation and translation as in a Transform
   * (X3D 4.0, 33.4.5). The clause specifies no order; other browsers use this one.
   */
  private static Matrix4f space(Node node) {
    float[] center = node.floats("center");
    float[] scale = node.floats("scale");
    float[] translation = node.floats("translation");
    float[] rotation = node.floats("rotation");
    Matrix4f matrix =
        new Matrix4f()
            .translate(translation[0], translation[1], translation[2])
            .translate(center[0], center[1], center[2]);
    double length =
        Math.sqrt(
            rotation[0] * rotation[0] + rotation[1] * rotation[1] + rotation[2] * rotation[2]);
    if (length > 0) {
      matrix.rotate(
          rotation[3],
          (float) (rotation[0] / length),
          (float) (rotation[1] / length),
          (float) (rotation[2] / length));
    }
    return matrix.scale(scale[0], scale[1], scale[2]).translate(-center[0], -center[1], -center[2]);
  }
}
