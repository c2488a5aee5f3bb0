package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Writes the transforms of texture coordinates as KHR_texture_transform. */
final class GltfTextureTransforms {
  private final GltfDocument out;
  private final GltfLosses losses;

  GltfTextureTransforms(GltfDocument out, GltfLosses losses) {
    this.out = out;
    this.losses = losses;
  }

  /**
   * Writes the transform of a texture, if it has one: that which its mapping names, or else the
   * first. Those of a MultiTexture are in a MultiTextureTransform only (X3D 4.0, 18.4.3).
   *
   * @param transforms the {@code textureTransform} of the appearance
   * @param info the textureInfo
   */
  void write(@Nullable NodeView transforms, String mapping, boolean multi, ObjectNode info) {
    if (transforms == null) {
      return;
    }
    boolean several = transforms.type().name().equals("MultiTextureTransform");
    if (multi && !several) {
      return;
    }
    List<NodeView> nodes =
        several ? List.copyOf(transforms.nodes("textureTransform")) : List.of(transforms);
    nodes.stream()
        .filter(node -> !mapping.isEmpty() && mapping.equals(mapping(node)))
        .findFirst()
        .or(() -> nodes.stream().findFirst())
        .ifPresent(node -> write(node, info));
  }

  private static String mapping(NodeView node) {
    return node.type().field("mapping").isEmpty() ? "" : node.string("mapping");
  }

  /**
   * Writes a TextureTransform as KHR_texture_transform. X3D moves, turns about a centre and scales
   * (X3D 4.0, 18.4.9), with t up; glTF scales, turns and moves, with v down. So a turn is kept only
   * where both axes are scaled alike.
   */
  private void write(NodeView transform, ObjectNode info) {
    if (!transform.type().name().equals("TextureTransform")) {
      losses.node(transform);
      return;
    }
    float[] c = transform.floats("center");
    float[] s = transform.floats("scale");
    float[] move = transform.floats("translation");
    double turn = GltfDocument.finite(transform.number("rotation"));
    if (turn != 0 && s[0] != s[1]) {
      losses.tell(
          "TextureTransform",
          transform.location(),
          "glTF cannot turn an image and scale its axes differently; the rotation of such a"
              + " TextureTransform is left out");
      turn = 0;
    }
    double cos = Math.cos(turn);
    double sin = Math.sin(turn);
    double x = (double) c[0] + move[0];
    double y = (double) c[1] + move[1];
    double b = -s[0] * sin;
    double d = s[1] * cos;
    double offsetS = s[0] * cos * x + b * y - c[0];
    double offsetT = s[1] * sin * x + d * y - c[1];
    double offsetU = b + offsetS;
    double offsetV = 1 - d - offsetT;
    if (offsetU == 0 && offsetV == 0 && turn == 0 && s[0] == 1 && s[1] == 1) {
      return;
    }
    ObjectNode extension = out.extension(info, "KHR_texture_transform");
    GltfDocument.numbers(extension, "offset", offsetU, offsetV);
    extension.put("rotation", turn);
    GltfDocument.numbers(extension, "scale", s[0], s[1]);
  }
}
