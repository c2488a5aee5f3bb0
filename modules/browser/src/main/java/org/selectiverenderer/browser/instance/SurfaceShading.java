package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/**
 * Where the light on a surface is computed, as a MetadataString of the name {@value #NAME} in the
 * metadata of its Appearance says. Other browsers pass it over.
 */
public enum SurfaceShading {
  /** As the renderer is set; without such metadata. */
  UNSPECIFIED,
  /** At each pixel, with interpolated normals (Phong). */
  PIXEL,
  /** At each vertex of the geometry as it is, with interpolated colours (Gouraud). */
  VERTEX,
  /** With one normal for each face, which shows the facets. */
  FLAT;

  /** The name of the MetadataString. */
  public static final String NAME = "shading";

  /** Reads the metadata of an Appearance: the MetadataString itself, or one in a MetadataSet. */
  static SurfaceShading of(Node appearance) {
    Node metadata = appearance.node("metadata");
    if (metadata == null) {
      return UNSPECIFIED;
    }
    if (!metadata.type().name().equals("MetadataSet")) {
      return word(metadata);
    }
    return metadata.nodes("value").stream()
        .map(SurfaceShading::word)
        .filter(shading -> shading != UNSPECIFIED)
        .findFirst()
        .orElse(UNSPECIFIED);
  }

  private static SurfaceShading word(Node metadata) {
    if (!metadata.type().name().equals("MetadataString")
        || !metadata.string("name").strip().equals(NAME)) {
      return UNSPECIFIED;
    }
    String[] values = (String[]) metadata.value(metadata.type().indexOf("value"));
    return values.length == 0 ? UNSPECIFIED : of(values[0]);
  }

  private static SurfaceShading of(@Nullable String word) {
    return Arrays.stream(values())
        .filter(shading -> shading != UNSPECIFIED)
        .filter(shading -> shading.name().equals(String.valueOf(word).strip().toUpperCase(Locale.ROOT)))
        .findFirst()
        .orElse(UNSPECIFIED);
  }
}
