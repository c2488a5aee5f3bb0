package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** Reads an Appearance node and what is in it (X3D 4.0, 12.4). */
final class AppearanceReader {
  private static final float[] BLACK = {0, 0, 0};

  private AppearanceReader() {}

  /**
   * @param geometry the geometry whose texture coordinates and colours the appearance uses
   */
  static SurfaceMaterial read(
      @Nullable Node appearance, @Nullable Node geometry, AssetProvider assets) {
    if (appearance == null || !appearance.type().name().equals("Appearance")) {
      return SurfaceMaterial.UNLIT_WHITE;
    }
    Node material = appearance.node("material");
    TextureUnits units = TextureUnits.of(appearance, geometry, assets);
    SurfaceMaterial plain = material(material, units, colorsHaveOpacity(geometry));
    return plain.with(
        ExtendedMaterialReader.read(appearance, material, units), SurfaceShading.of(appearance));
  }

  /** The opacity of a ColorRGBA replaces the material's (X3D 4.0, 11.4.3). */
  private static boolean colorsHaveOpacity(@Nullable Node geometry) {
    if (geometry == null || geometry.type().field("color").isEmpty()) {
      return false;
    }
    Node color = geometry.node("color");
    return color != null && color.type().name().equals("ColorRGBA");
  }

  private static SurfaceMaterial material(@Nullable Node node, TextureUnits units, boolean opaque) {
    String name = node == null ? "" : node.type().name();
    if (node == null || !MaterialFields.known(name)) {
      float[] white = SurfaceMaterial.UNLIT_WHITE.emissive();
      return new MaterialFields(false, white, BLACK, white, 0, 0, 0).surface(units);
    }
    return MaterialFields.of(node, "", opaque).surface(units);
  }

  /** The colours of a material. */
  record MaterialFields(
      boolean lit,
      float[] diffuse,
      float[] specular,
      float[] emissive,
      float ambient,
      float shininess,
      float transparency) {

    static boolean known(String type) {
      return switch (type) {
        case "Material", "TwoSidedMaterial", "UnlitMaterial", "PhysicalMaterial" -> true;
        default -> false;
      };
    }

    /**
     * @param side "" for the front, "back" for a TwoSidedMaterial's back
     * @param opaque whether the material's transparency is ignored
     */
    static MaterialFields of(Node node, String side, boolean opaque) {
      float transparency = opaque ? 0 : node.number(field(side, "transparency"));
      return switch (node.type().name()) {
        case "UnlitMaterial" -> {
          float[] colour = node.floats("emissiveColor");
          yield new MaterialFields(false, colour, BLACK, colour, 0, 0, transparency);
        }
        case "PhysicalMaterial" ->
            // The shader takes the colours from here; roughness and metalness are in the detail's
            // numbers.
            new MaterialFields(
                true,
                node.floats("baseColor"),
                BLACK,
                node.floats("emissiveColor"),
                1,
                0,
                transparency);
        default ->
            new MaterialFields(
                true,
                node.floats(field(side, "diffuseColor")),
                node.floats(field(side, "specularColor")),
                node.floats(field(side, "emissiveColor")),
                node.number(field(side, "ambientIntensity")),
                node.number(field(side, "shininess")),
                transparency);
      };
    }

    private static String field(String side, String name) {
      return side.isEmpty()
          ? name
          : side + Character.toUpperCase(name.charAt(0)) + name.substring(1);
    }

    SurfaceMaterial surface(TextureUnits units) {
      return new SurfaceMaterial(
          lit,
          diffuse,
          specular,
          emissive,
          ambient,
          shininess,
          transparency,
          units.plainTexture(),
          units.plainTints(),
          units.plainGlow(),
          units.plainTransform(),
          null,
          SurfaceShading.UNSPECIFIED);
    }
  }
}
