package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Writes appearances as materials. The numbers of a PhysicalMaterial are those of glTF. Colours of
 * Material and UnlitMaterial are those of the screen, so they become linear by the curve of sRGB. A
 * Material is not metallic; its roughness is (2 / (n + 2))^(1/4) with the specular exponent n = 128
 * shininess, which gives both highlights the same width (Walter et al. 2007, alpha = roughness^2),
 * and 1 without a specular colour.
 */
final class GltfMaterialWriter {
  private static final float[] WHITE = {1, 1, 1};
  private static final double[] BLACK = {0, 0, 0};

  /**
   * Holds what a material depends on besides its appearance.
   *
   * @param texCoords the mesh's texture coordinates
   * @param coloured whether its vertices have colours, which replace the diffuse one
   * @param translucent whether one of these is not opaque
   * @param lit whether it has normals
   * @param solid whether back faces are not drawn
   * @param multiply whether images multiply the colour, else they replace it
   */
  record Use(
      GltfTexCoordSets texCoords,
      boolean coloured,
      boolean translucent,
      boolean lit,
      boolean solid,
      boolean multiply) {}

  private record Key(@Nullable NodeView appearance, Use use) {}

  private final GltfDocument out;
  private final GltfTextureWriter textures;
  private final GltfTextureTransforms transforms;
  private final GltfLosses losses;
  private final GltfMetadata metadata;
  private final Map<Key, Integer> known = new HashMap<>();

  GltfMaterialWriter(
      GltfDocument out, GltfTextureWriter textures, GltfLosses losses, GltfMetadata metadata) {
    this.out = out;
    this.textures = textures;
    transforms = new GltfTextureTransforms(out, losses);
    this.losses = losses;
    this.metadata = metadata;
  }

  /** Returns whether an appearance has glTF's own material, whose colours are linear. */
  static boolean physical(@Nullable NodeView appearance) {
    NodeView material = field(appearance, "material");
    return material != null && material.type().name().equals("PhysicalMaterial");
  }

  /** Returns the index of the material of an appearance. */
  int material(@Nullable NodeView appearance, Use use, GltfPlace place) throws IOException {
    Key key = new Key(appearance, use);
    Integer index = known.get(key);
    if (index == null) {
      index = out.add("materials", write(appearance, use, place));
      known.put(key, index);
    }
    return index;
  }

  private ObjectNode write(@Nullable NodeView appearance, Use use, GltfPlace place)
      throws IOException {
    ObjectNode to = out.object();
    NodeView material = field(appearance, "material");
    String type = material == null ? "" : material.type().name();
    NodeView named = material != null && material.name() != null ? material : appearance;
    if (named != null && named.name() != null) {
      to.put("name", named.name());
    }
    ObjectNode surface = to.putObject("pbrMetallicRoughness");
    boolean phong = type.equals("Material") || type.equals("TwoSidedMaterial");
    boolean unlit = !use.lit() || !phong && !type.equals("PhysicalMaterial");
    String colour =
        !use.lit() && !type.isEmpty() || type.equals("UnlitMaterial")
            ? "emissive"
            : phong ? "diffuse" : "base";
    float[] rgb = colour(material, colour + "Color");
    NodeView moved = field(appearance, "textureTransform");
    Optional<GltfTextureWriter.Texture> image =
        image(
            field(appearance, "texture"),
            moved,
            material,
            colour + "Texture",
            surface,
            "baseColorTexture",
            use,
            place);
    boolean replaced = image.isPresent() && phong && !use.multiply() && !image.get().image().grey();
    rgb = use.coloured() || replaced ? WHITE : rgb;
    double opacity = material == null ? 1 : 1 - unit(number(material, "transparency"));
    double[] base = type.equals("PhysicalMaterial") ? plain(rgb) : linear(rgb);
    GltfDocument.numbers(surface, "baseColorFactor", base[0], base[1], base[2], opacity);
    surface.put("metallicFactor", 0.0);
    if (unlit) {
      out.extension(to, "KHR_materials_unlit");
      surface.put("roughnessFactor", 1.0);
    } else if (material != null) {
      lit(appearance, material, surface, to, use, place);
    }
    boolean translucent =
        opacity < 1 || use.translucent() || image.isPresent() && image.get().image().translucent();
    alpha(appearance, translucent, to);
    to.put("doubleSided", !use.solid());
    if (material != null) {
      metadata.append(material, to);
      if (type.equals("TwoSidedMaterial")) {
        losses.tell(
            type, material.location(), "glTF has one material for both sides; the back's is lost");
      }
    }
    return to;
  }

  private void lit(
      @Nullable NodeView appearance,
      NodeView material,
      ObjectNode surface,
      ObjectNode to,
      Use use,
      GltfPlace place)
      throws IOException {
    boolean physical = material.type().name().equals("PhysicalMaterial");
    NodeView moved = field(appearance, "textureTransform");
    float[] emissive = colour(material, "emissiveColor");
    double[] glow = physical ? plain(emissive) : linear(emissive);
    if (physical) {
      surface.put("metallicFactor", unit(number(material, "metallic")));
      surface.put("roughnessFactor", unit(number(material, "roughness")));
      image(
          null,
          moved,
          material,
          "metallicRoughnessTexture",
          surface,
          "metallicRoughnessTexture",
          use,
          place);
    } else {
      surface.put("roughnessFactor", roughness(material));
      losses(material, "ambientTexture", "specularTexture", "shininessTexture");
      tellColours(material);
    }
    if (glow[0] + glow[1] + glow[2] > 0) {
      GltfDocument.numbers(to, "emissiveFactor", glow);
      image(null, moved, material, "emissiveTexture", to, "emissiveTexture", use, place);
    } else {
      GltfDocument.numbers(to, "emissiveFactor", BLACK);
    }
    if (image(null, moved, material, "normalTexture", to, "normalTexture", use, place)
        .isPresent()) {
      to.withObject("/normalTexture").put("scale", number(material, "normalScale"));
    }
    if (image(null, moved, material, "occlusionTexture", to, "occlusionTexture", use, place)
        .isPresent()) {
      to.withObject("/occlusionTexture")
          .put("strength", unit(number(material, "occlusionStrength")));
    }
    if (appearance != null) {
      losses(appearance, "backMaterial", "fillProperties");
      if (!appearance.nodes("shaders").isEmpty()) {
        losses.node(appearance.nodes("shaders").get(0));
      }
    }
  }

  private void tellColours(NodeView material) {
    float[] specular = colour(material, "specularColor");
    if (specular[0] + specular[1] + specular[2] > 0) {
      losses.note(
          "specular",
          material.location(),
          "glTF has neither a specularColor nor an ambientIntensity; highlights follow from the"
              + " roughness, which is that of shininess");
    }
  }

  private void losses(NodeView node, String... fields) {
    for (String name : fields) {
      NodeView held = field(node, name);
      if (held != null) {
        losses.tell(
            name,
            held.location(),
            "glTF has nothing for the %s of %s; it is left out"
                .formatted(name, node.type().name()));
      }
    }
  }

  /** Writes the texture of a material's field, or else another one. */
  private Optional<GltfTextureWriter.Texture> image(
      @Nullable NodeView otherwise,
      @Nullable NodeView transform,
      @Nullable NodeView material,
      String field,
      ObjectNode to,
      String property,
      Use use,
      GltfPlace place)
      throws IOException {
    NodeView own = field(material, field);
    NodeView node = own == null ? otherwise : own;
    if (use.texCoords().isEmpty() || node == null) {
      return Optional.empty();
    }
    String mapping = own == null || material == null ? "" : mapping(material, field);
    int set = use.texCoords().number(mapping);
    if (set == GltfTexCoordSets.NONE) {
      losses.tell(
          "TextureCoordinateGenerator",
          node.location(),
          "glTF has no TextureCoordinateGenerator; textures with coordinates that are generated or"
              + " not of two dimensions are left out");
      return Optional.empty();
    }
    Optional<GltfTextureWriter.Texture> texture = textures.texture(node, place);
    if (texture.isPresent()) {
      ObjectNode info = to.putObject(property).put("index", texture.get().index());
      if (set > 0) {
        info.put("texCoord", set);
      }
      transforms.write(transform, mapping, node.type().name().equals("MultiTexture"), info);
    }
    return texture;
  }

  /** Returns the name of the coordinates and of the transform of a material's texture, or "". */
  private static String mapping(NodeView material, String texture) {
    String field = texture + "Mapping";
    return material.type().field(field).isEmpty() ? "" : material.string(field);
  }

  private static void alpha(@Nullable NodeView appearance, boolean translucent, ObjectNode to) {
    String mode =
        appearance != null && appearance.type().field("alphaMode").isPresent()
            ? appearance.string("alphaMode").toUpperCase(Locale.ROOT)
            : "AUTO";
    switch (mode) {
      case "OPAQUE" -> to.put("alphaMode", "OPAQUE");
      case "MASK" -> {
        double cutoff = appearance == null ? 0.5 : number(appearance, "alphaCutoff");
        to.put("alphaMode", "MASK").put("alphaCutoff", Math.max(0, cutoff));
      }
      case "BLEND" -> to.put("alphaMode", "BLEND");
      default -> to.put("alphaMode", translucent ? "BLEND" : "OPAQUE");
    }
  }

  private static double roughness(NodeView material) {
    float[] specular = colour(material, "specularColor");
    double exponent = 128 * unit(number(material, "shininess"));
    return specular[0] + specular[1] + specular[2] == 0 ? 1 : Math.pow(2 / (exponent + 2), 0.25);
  }

  private static @Nullable NodeView field(@Nullable NodeView node, String name) {
    return node == null || node.type().field(name).isEmpty() ? null : node.node(name);
  }

  private static float[] colour(@Nullable NodeView node, String name) {
    return node == null || node.type().field(name).isEmpty() ? WHITE : node.floats(name);
  }

  private static double number(NodeView node, String name) {
    return node.type().field(name).isEmpty()
        ? 0
        : GltfDocument.finite(Double.parseDouble(Float.toString(node.number(name))));
  }

  private static double unit(double value) {
    return value >= 0 ? Math.min(value, 1) : 0;
  }

  private static double[] plain(float[] rgb) {
    return new double[] {unit(rgb[0]), unit(rgb[1]), unit(rgb[2])};
  }

  private static double[] linear(float[] rgb) {
    double[] values = plain(rgb);
    return new double[] {Srgb.light(values[0]), Srgb.light(values[1]), Srgb.light(values[2])};
  }
}
