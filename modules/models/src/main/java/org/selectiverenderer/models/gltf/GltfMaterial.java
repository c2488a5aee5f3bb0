package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.models.scene.Numbers;

/**
 * A material of a glTF file.
 *
 * @param json its object; missing for glTF's default material
 */
record GltfMaterial(JsonNode json) {
  static final String GLOSSY = "KHR_materials_pbrSpecularGlossiness";

  /** Returns whether no light falls on it. */
  boolean isUnlit() {
    return json.path("extensions").has("KHR_materials_unlit");
  }

  boolean isTwoSided() {
    return json.path("doubleSided").asBoolean(false);
  }

  /** Returns whether normals of a texture are added to those of a surface. */
  boolean hasNormalTexture() {
    return !isUnlit() && json.has("normalTexture");
  }

  /** Returns red, green, blue and opacity, by which vertex colours are multiplied. */
  double[] baseColor() {
    return GltfFile.numbers(pbr(), "baseColorFactor", 1, 1, 1, 1);
  }

  /**
   * Returns the metallic-roughness part; for a material that has only diffuse colour and glossiness
   * (KHR_materials_pbrSpecularGlossiness), a part of no metal.
   */
  JsonNode pbr() {
    JsonNode glossy = json.path("extensions").path(GLOSSY);
    if (json.has("pbrMetallicRoughness") || !glossy.isObject()) {
      return json.path("pbrMetallicRoughness");
    }
    ObjectNode part = JsonNodeFactory.instance.objectNode();
    if (glossy.has("diffuseFactor")) {
      part.set("baseColorFactor", glossy.get("diffuseFactor"));
    }
    if (glossy.has("diffuseTexture")) {
      part.set("baseColorTexture", glossy.get("diffuseTexture"));
    }
    part.put("metallicFactor", 0.0);
    double glossiness = Numbers.unit(GltfFile.number(glossy, "glossinessFactor", 1));
    return part.put("roughnessFactor", 1 - glossiness);
  }

  /** Returns the channels of texture coordinates that its textures need, in their order. */
  List<TextureChannel> channels() {
    List<TextureChannel> channels = new ArrayList<>();
    for (JsonNode info : textureInfos()) {
      TextureChannel channel = TextureChannel.of(info);
      if (info.isObject() && !channels.contains(channel)) {
        channels.add(channel);
      }
    }
    return channels;
  }

  private List<JsonNode> textureInfos() {
    JsonNode pbr = pbr();
    if (isUnlit()) {
      return List.of(pbr.path("baseColorTexture"));
    }
    return List.of(
        pbr.path("baseColorTexture"),
        pbr.path("metallicRoughnessTexture"),
        json.path("normalTexture"),
        json.path("occlusionTexture"),
        json.path("emissiveTexture"));
  }
}
