package org.selectiverenderer.runtime.instance;

import java.util.Optional;
import org.joml.Matrix3f;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/** Reads an Appearance node and what is in it (X3D 4.0, 12.4). */
final class SurfaceReader {
  private static final float[] BLACK = {0, 0, 0};

  private SurfaceReader() {}

  static Surface read(@Nullable Node appearance, Assets assets) {
    if (appearance == null || !appearance.type().name().equals("Appearance")) {
      return Surface.UNLIT_WHITE;
    }
    Node material = appearance.node("material");
    Texture texture = texture(appearance.node("texture"), assets).orElse(null);
    float[] transform = transform(appearance.node("textureTransform"));
    if (material == null) {
      return unlit(Surface.UNLIT_WHITE.emissive(), 0, texture, transform);
    }
    return switch (material.type().name()) {
      case "Material", "TwoSidedMaterial" ->
          new Surface(
              true,
              material.floats("diffuseColor"),
              material.floats("specularColor"),
              material.floats("emissiveColor"),
              material.number("ambientIntensity"),
              material.number("shininess"),
              material.number("transparency"),
              texture != null ? texture : own(material, "diffuseTexture", assets),
              transform);
      case "UnlitMaterial" ->
          unlit(
              material.floats("emissiveColor"),
              material.number("transparency"),
              texture != null ? texture : own(material, "emissiveTexture", assets),
              transform);
      case "PhysicalMaterial" -> physical(material, texture, transform, assets);
      default -> unlit(Surface.UNLIT_WHITE.emissive(), 0, texture, transform);
    };
  }

  private static Surface unlit(
      float[] colour, float transparency, @Nullable Texture texture, float @Nullable [] transform) {
    return new Surface(false, colour, BLACK, colour, 0, 0, transparency, texture, transform);
  }

  /**
   * A physical material through the lighting model of Material: the base colour diffuse as far as
   * it is no metal, a highlight that sharpens as roughness falls. An approximation that keeps the
   * scene recognisable.
   */
  private static Surface physical(
      Node material, @Nullable Texture texture, float @Nullable [] transform, Assets assets) {
    float[] base = material.floats("baseColor");
    float metallic = material.number("metallic");
    float roughness = material.number("roughness");
    float[] specular = new float[3];
    for (int i = 0; i < 3; i++) {
      specular[i] = (1 - roughness) * (0.04f + metallic * (base[i] - 0.04f));
    }
    return new Surface(
        true,
        base,
        specular,
        material.floats("emissiveColor"),
        0.2f,
        Math.max(0.01f, 1 - roughness),
        material.number("transparency"),
        texture != null ? texture : own(material, "baseTexture", assets),
        transform);
  }

  private static @Nullable Texture own(Node material, String field, Assets assets) {
    return material.type().field(field).isEmpty()
        ? null
        : texture(material.node(field), assets).orElse(null);
  }

  private static Optional<Texture> texture(@Nullable Node node, Assets assets) {
    if (node == null) {
      return Optional.empty();
    }
    if (node.type().name().equals("MultiTexture")) {
      return node.nodes("texture").stream().findFirst().flatMap(first -> texture(first, assets));
    }
    return assets
        .image(node)
        .map(image -> new Texture(image, node.bool("repeatS"), node.bool("repeatT")));
  }

  /** Tc' = -C S R C T Tc (X3D 4.0, 18.4.8). */
  private static float @Nullable [] transform(@Nullable Node node) {
    if (node == null || !node.type().name().equals("TextureTransform")) {
      return null;
    }
    float[] center = node.floats("center");
    float[] scale = node.floats("scale");
    float[] translation = node.floats("translation");
    return move(-center[0], -center[1])
        .mul(new Matrix3f().scale(scale[0], scale[1], 1))
        .mul(new Matrix3f().rotationZ(node.number("rotation")))
        .mul(move(center[0], center[1]))
        .mul(move(translation[0], translation[1]))
        .get(new float[9]);
  }

  private static Matrix3f move(float s, float t) {
    return new Matrix3f().m20(s).m21(t);
  }
}
