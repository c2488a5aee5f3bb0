package org.selectiverenderer.runtime.nodes;

import java.util.Set;

/**
 * The node types without a behaviour that others read: to draw, to light, to describe. Geometry is
 * not among them: whoever makes meshes of it knows which he can.
 */
final class PassiveNodes {
  private static final Set<String> SHAPES =
      Set.of(
          "Shape",
          "Appearance",
          "Material",
          "UnlitMaterial",
          "PhysicalMaterial",
          "TwoSidedMaterial",
          "ImageTexture",
          "PixelTexture",
          "MultiTexture",
          "TextureTransform");

  private static final Set<String> GEOMETRY_DATA =
      Set.of(
          "Color",
          "ColorRGBA",
          "Coordinate",
          "CoordinateDouble",
          "FontStyle",
          "MultiTextureCoordinate",
          "Normal",
          "TextureCoordinate");

  private static final Set<String> LIGHTS = Set.of("DirectionalLight", "PointLight", "SpotLight");

  private static final Set<String> DESCRIPTIONS =
      Set.of(
          "MetadataBoolean",
          "MetadataDouble",
          "MetadataFloat",
          "MetadataInteger",
          "MetadataSet",
          "MetadataString",
          "WorldInfo");

  private PassiveNodes() {}

  static boolean isRead(String typeName) {
    return SHAPES.contains(typeName)
        || GEOMETRY_DATA.contains(typeName)
        || LIGHTS.contains(typeName)
        || DESCRIPTIONS.contains(typeName);
  }
}
