package org.selectiverenderer.models;

import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_DIFFUSE;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_EMISSIVE;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_COLOR_SPECULAR;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_OPACITY;
import static org.lwjgl.assimp.Assimp.AI_MATKEY_SHININESS;
import static org.lwjgl.assimp.Assimp.aiGetMaterialColor;
import static org.lwjgl.assimp.Assimp.aiGetMaterialFloatArray;
import static org.lwjgl.assimp.Assimp.aiGetMaterialTexture;
import static org.lwjgl.assimp.Assimp.aiGetMaterialTextureCount;
import static org.lwjgl.assimp.Assimp.aiReturn_SUCCESS;
import static org.lwjgl.assimp.Assimp.aiTextureType_BASE_COLOR;
import static org.lwjgl.assimp.Assimp.aiTextureType_DIFFUSE;
import static org.lwjgl.assimp.Assimp.aiTextureType_NONE;

import java.nio.IntBuffer;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.lwjgl.assimp.AIColor4D;
import org.lwjgl.assimp.AIMaterial;
import org.lwjgl.assimp.AIString;
import org.lwjgl.system.MemoryStack;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Converts an Assimp material to an Appearance node. */
final class AssimpMaterialConverter {
  /** X3D's shininess times this is the specular exponent (X3D 4.0, 17.2.2.4). */
  private static final float EXPONENT = 128;

  private final AIMaterial material;
  private final NodeCatalogue catalogue;

  AssimpMaterialConverter(AIMaterial material, NodeCatalogue catalogue) {
    this.material = material;
    this.catalogue = catalogue;
  }

  ParsedNode appearance(Path file, ProblemCollector problems) {
    SourceLocation location = SourceLocation.of(file.toString());
    ParsedNode appearance = node("Appearance", location);
    ParsedNode look = node("Material", location);
    put(appearance, "material", look);
    color(look, AI_MATKEY_COLOR_DIFFUSE, "diffuseColor");
    color(look, AI_MATKEY_COLOR_SPECULAR, "specularColor");
    color(look, AI_MATKEY_COLOR_EMISSIVE, "emissiveColor");
    put(look, "shininess", Math.min(1, Math.max(0, number(AI_MATKEY_SHININESS, 0) / EXPONENT)));
    put(look, "transparency", Math.min(1, Math.max(0, 1 - number(AI_MATKEY_OPACITY, 1))));
    String texture = texture();
    if (texture != null && texture.startsWith("*")) {
      problems.warning(
          location, "a texture is inside the file, where X3D cannot refer to it; it is left out");
    } else if (texture != null) {
      ParsedNode image = node("ImageTexture", location);
      put(image, "url", new String[] {texture.replace('\\', '/')});
      put(appearance, "texture", image);
    }
    return appearance;
  }

  private ParsedNode node(String type, SourceLocation location) {
    return new ParsedNode(catalogue.get(type), null, location);
  }

  private static void put(ParsedNode node, String field, Object value) {
    node.put(node.type().indexOf(field), value);
  }

  private void color(ParsedNode look, String key, String field) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      AIColor4D color = AIColor4D.calloc(stack);
      if (aiGetMaterialColor(material, key, aiTextureType_NONE, 0, color) == aiReturn_SUCCESS) {
        put(look, field, new float[] {unit(color.r()), unit(color.g()), unit(color.b())});
      }
    }
  }

  private static float unit(float value) {
    return value >= 0 ? Math.min(value, 1) : 0;
  }

  private float number(String key, float otherwise) {
    float[] value = {otherwise};
    int[] count = {1};
    boolean found =
        aiGetMaterialFloatArray(material, key, aiTextureType_NONE, 0, value, count)
            == aiReturn_SUCCESS;
    return found && Float.isFinite(value[0]) ? value[0] : otherwise;
  }

  private @Nullable String texture() {
    for (int kind : new int[] {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      if (aiGetMaterialTextureCount(material, kind) > 0) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
          AIString path = AIString.calloc(stack);
          int result =
              aiGetMaterialTexture(
                  material, kind, 0, path, (IntBuffer) null, null, null, null, null, null);
          if (result == aiReturn_SUCCESS) {
            return path.dataString();
          }
        }
      }
    }
    return null;
  }
}
