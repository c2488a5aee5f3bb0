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
  private final ImportedImages pictures;
  private final NodeCatalogue catalogue;

  /**
   * @param pictures the pictures of the model
   */
  ImportedMaterialConverter(
      ImportedMaterial material, ImportedImages pictures, NodeCatalogue catalogue) {
    this.material = material;
    this.pictures = pictures;
    this.catalogue = catalogue;
  }

  /**
   * Returns the Appearance.
   *
   * @param def its DEF name; null for none
   */
  ParsedNode appearance(String file, @Nullable String def, ProblemCollector problems) {
    SourceLocation location = SourceLocation.of(file);
    ParsedNode appearance = new ParsedNode(catalogue.get("Appearance"), def, location);
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
    String url = texture == null ? "" : pictures.url(texture);
    if (!url.isEmpty()) {
      ParsedNode image = node("ImageTexture", location);
      put(image, "url", new String[] {url});
      put(appearance, "texture", image);
    } else if (texture != null) {
      problems.warning(
          location, "a texture is inside the file in a form that is not read; it is left out");
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
