package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes glTF's materials as Appearances: PhysicalMaterial, and UnlitMaterial for
 * KHR_materials_unlit and for lines and points, on which glTF has no light fall either.
 */
final class GltfMaterials {
  private static final double DEFAULT_CUTOFF = 0.5;

  /**
   * Describes how a surface is drawn.
   *
   * @param index the index of the material; -1 for glTF's default
   * @param lit whether light falls on it
   */
  private record Key(int index, boolean lit) {}

  private final GltfFile file;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final GltfTextures textures;
  private final Map<Key, String> written = new HashMap<>();

  GltfMaterials(GltfTranslation shared) {
    file = shared.file();
    out = shared.out();
    names = shared.names();
    problems = shared.problems();
    textures = new GltfTextures(shared);
  }

  /** Returns the material of a primitive. */
  GltfMaterial material(int index) {
    return new GltfMaterial(file.part("materials", index));
  }

  /** Returns whether one set of coordinates without transforms serves all textures. */
  static boolean plain(List<TextureChannel> channels) {
    return channels.isEmpty()
        || channels.size() == 1 && channels.get(0).set() == 0 && !channels.get(0).isTransformed();
  }

  /**
   * Writes the Appearance of a material, and one that has been written as a USE.
   *
   * @param lit false for lines and points
   */
  void write(int index, boolean lit) {
    GltfMaterial surface = material(index);
    JsonNode material = surface.json();
    Key key = new Key(material.isMissingNode() ? -1 : index, lit);
    String known = written.get(key);
    if (known != null) {
      out.empty("Appearance", "USE", known);
      return;
    }
    String def = names.unique(material.path("name").asText(""), "material" + Math.max(0, index));
    written.put(key, def);
    String path = "materials[%d]".formatted(index);
    String mode = material.path("alphaMode").asText("OPAQUE");
    out.open("Appearance", "DEF", def);
    out.attribute("alphaMode", mode.equals("MASK") || mode.equals("BLEND") ? mode : "OPAQUE");
    if (mode.equals("MASK")) {
      out.attribute(
          "alphaCutoff",
          Numbers.of(Numbers.unit(GltfFile.number(material, "alphaCutoff", DEFAULT_CUTOFF))));
    }
    List<TextureChannel> channels = surface.channels();
    if (lit && !surface.isUnlit()) {
      physical(surface, path, channels);
    } else {
      flat(surface, path, channels);
    }
    transforms(path, channels);
    out.close();
    tellExtensions(material, path);
  }

  private void physical(GltfMaterial surface, String path, List<TextureChannel> channels) {
    JsonNode material = surface.json();
    JsonNode pbr = surface.pbr();
    double[] base = surface.baseColor();
    double[] glow = emission(material, path);
    JsonNode normal = material.path("normalTexture");
    JsonNode occlusion = material.path("occlusionTexture");
    out.open("PhysicalMaterial");
    out.attribute("baseColor", color(base));
    out.attribute("metallic", Numbers.of(Numbers.unit(GltfFile.number(pbr, "metallicFactor", 1))));
    out.attribute(
        "roughness", Numbers.of(Numbers.unit(GltfFile.number(pbr, "roughnessFactor", 1))));
    out.attribute("emissiveColor", color(glow));
    out.attribute("transparency", Numbers.of(1 - Numbers.unit(base[3])));
    if (normal.isObject()) {
      double scale = Math.max(0, GltfFile.number(normal, "scale", 1));
      out.attribute("normalScale", Numbers.of(scale));
    }
    if (occlusion.isObject()) {
      double strength = Numbers.unit(GltfFile.number(occlusion, "strength", 1));
      out.attribute("occlusionStrength", Numbers.of(strength));
    }
    JsonNode metallic = pbr.path("metallicRoughnessTexture");
    JsonNode emissive = material.path("emissiveTexture");
    mapping("baseTextureMapping", pbr.path("baseColorTexture"), channels);
    mapping("metallicRoughnessTextureMapping", metallic, channels);
    mapping("normalTextureMapping", normal, channels);
    mapping("occlusionTextureMapping", occlusion, channels);
    mapping("emissiveTextureMapping", emissive, channels);
    String inPbr = path + ".pbrMetallicRoughness.";
    texture(pbr.path("baseColorTexture"), inPbr + "baseColorTexture", "baseTexture");
    texture(metallic, inPbr + "metallicRoughnessTexture", "metallicRoughnessTexture");
    texture(normal, path + ".normalTexture", "normalTexture");
    texture(occlusion, path + ".occlusionTexture", "occlusionTexture");
    texture(emissive, path + ".emissiveTexture", "emissiveTexture");
    out.close();
  }

  /** Writes a material on which no light falls; X3D shows its colour as it is, which is sRGB. */
  private void flat(GltfMaterial surface, String path, List<TextureChannel> channels) {
    double[] base = surface.baseColor();
    JsonNode picture = surface.pbr().path("baseColorTexture");
    out.open("UnlitMaterial", "emissiveColor", color(srgb(base)));
    out.attribute("transparency", Numbers.of(1 - Numbers.unit(base[3])));
    mapping("emissiveTextureMapping", picture, channels);
    texture(picture, path + ".pbrMetallicRoughness.baseColorTexture", "emissiveTexture");
    out.close();
  }

  private double[] emission(JsonNode material, String path) {
    double[] glow = GltfFile.numbers(material, "emissiveFactor", 0, 0, 0);
    JsonNode extension = material.path("extensions").path("KHR_materials_emissive_strength");
    double strength = GltfFile.number(extension, "emissiveStrength", 1);
    double most = 0;
    for (int i = 0; i < glow.length; i++) {
      glow[i] *= strength;
      most = Math.max(most, glow[i]);
    }
    if (most > 1) {
      problems.tell(path, "it emits more light than X3D can express; it is as bright as white");
      double brightest = most;
      for (int i = 0; i < glow.length; i++) {
        glow[i] /= brightest;
      }
    }
    return glow;
  }

  private void mapping(String field, JsonNode info, List<TextureChannel> channels) {
    if (info.isObject() && !plain(channels)) {
      out.attribute(field, mappingName(channels.indexOf(TextureChannel.of(info))));
    }
  }

  /**
   * Returns the name by which textures, coordinates and transforms of a channel belong together.
   */
  static String mappingName(int channel) {
    return "channel" + channel;
  }

  private void texture(JsonNode info, String path, String container) {
    if (info.isObject()) {
      textures.write(GltfFile.index(info, "index"), path, container);
    }
  }

  private void transforms(String path, List<TextureChannel> channels) {
    long transformed = channels.stream().filter(TextureChannel::isTransformed).count();
    if (transformed == 0) {
      return;
    }
    boolean several = transformed > 1;
    if (several) {
      out.open("MultiTextureTransform", "containerField", "textureTransform");
    }
    for (int i = 0; i < channels.size(); i++) {
      TextureChannel channel = channels.get(i);
      if (!channel.isTransformed()) {
        continue;
      }
      if (!channel.isExpressible()) {
        problems.tell(
            path,
            "KHR_texture_transform scales differently along both axes and rotates, which X3D's "
                + "TextureTransform cannot express; the texture is not transformed");
        continue;
      }
      out.open("TextureTransform", "mapping", mappingName(i));
      String[] attributes = channel.attributes();
      for (int k = 0; k < attributes.length; k += 2) {
        out.attribute(attributes[k], attributes[k + 1]);
      }
      if (several) {
        out.attribute("containerField", "textureTransform");
      }
      out.close();
    }
    if (several) {
      out.close();
    }
  }

  private void tellExtensions(JsonNode material, String path) {
    material
        .path("extensions")
        .fieldNames()
        .forEachRemaining(
            name -> {
              switch (name) {
                case "KHR_materials_unlit", "KHR_materials_emissive_strength" -> {
                  // expressed
                }
                case GltfMaterial.GLOSSY -> {
                  if (!material.has("pbrMetallicRoughness")) {
                    problems.tell(
                        path,
                        "its specular colour and texture of glossiness have no equal in X3D; its "
                            + "diffuse colour and its glossiness are shown as those of no metal");
                  }
                }
                default -> {
                  String shown = name.length() > 60 ? name.substring(0, 60) : name;
                  problems.tell(
                      path,
                      "X3D has nothing like the extension %s, which is left out".formatted(shown));
                }
              }
            });
  }

  private static String color(double[] color) {
    return Numbers.of(Numbers.unit(color[0]), Numbers.unit(color[1]), Numbers.unit(color[2]));
  }

  /** Converts linear light to sRGB. */
  static double[] srgb(double[] linear) {
    double[] srgb = new double[3];
    for (int i = 0; i < srgb.length; i++) {
      srgb[i] = Srgb.display(Numbers.unit(linear[i]));
    }
    return srgb;
  }
}
