package org.selectiverenderer.models;

import java.util.Arrays;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Converts the material of an imported model to an Appearance node. */
final class ImportedMaterialConverter {
  /** X3D's shininess times this is the specular exponent (X3D 4.0, 17.2.2.4). */
  private static final float EXPONENT = 128;

  private static final float[] WHITE = {1, 1, 1};

  private final ImportedMaterial material;
  private final NodeCatalogue catalogue;

  ImportedMaterialConverter(ImportedMaterial material, NodeCatalogue catalogue) {
    this.material = material;
    this.catalogue = catalogue;
  }

  ParsedNode appearance(String file, ProblemCollector problems) {
    SourceLocation location = SourceLocation.of(file);
    ParsedNode appearance = node("Appearance", location);
    ParsedNode look = node("Material", location);
    put(appearance, "material", look);
    float exponent = number(material.specularExponent(), 0);
    boolean made = isMadeByAssimp(file, exponent);
    if (!made) {
      color(look, material.diffuse(), "diffuseColor");
    }
    if (exponent > 0) {
      // A highlight with an exponent of 0 would make the entire surface white.
      color(look, material.specular(), "specularColor");
    }
    color(look, material.emissive(), "emissiveColor");
    put(look, "shininess", unit(exponent / EXPONENT));
    put(look, "transparency", unit(1 - number(material.opacity(), 1)));
    String texture = material.texture();
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

  /**
   * Returns whether Assimp made the material for a file that has none: all white, whereas X3D shows
   * a surface of no colour in the grey of Material's default.
   */
  private boolean isMadeByAssimp(String file, float exponent) {
    String name = file.toLowerCase(Locale.ROOT);
    return (name.endsWith(".stl") || name.endsWith(".ply"))
        && exponent == 0
        && Arrays.equals(material.diffuse(), WHITE)
        && Arrays.equals(material.specular(), WHITE);
  }

  private ParsedNode node(String type, SourceLocation location) {
    return new ParsedNode(catalogue.get(type), null, location);
  }

  private static void put(ParsedNode node, String field, Object value) {
    node.put(node.type().indexOf(field), value);
  }

  private static void color(ParsedNode look, float @Nullable [] color, String field) {
    if (color != null) {
      put(look, field, new float[] {unit(color[0]), unit(color[1]), unit(color[2])});
    }
  }

  private static float unit(float value) {
    return value >= 0 ? Math.min(value, 1) : 0;
  }

  private static float number(@Nullable Float value, float otherwise) {
    return value != null && Float.isFinite(value) ? value : otherwise;
  }
}
