package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import java.util.Locale;
import org.selectiverenderer.browser.scene.NamedMetadata;
import org.selectiverenderer.browser.scene.Node;

/**
 * This says where the light on a surface is computed, as a MetadataString of the name {@value
 * #NAME} in the metadata of its Appearance says. Other browsers pass it over.
 */
public enum SurfaceShading {
  /** There are no such metadata: light is computed where the renderer is set to. */
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
    return NamedMetadata.find(appearance, "MetadataString", NAME)
        .map(metadata -> metadata.strings("value"))
        .filter(words -> words.length > 0)
        .map(words -> of(words[0]))
        .orElse(UNSPECIFIED);
  }

  private static SurfaceShading of(String word) {
    return Arrays.stream(values())
        .filter(shading -> shading != UNSPECIFIED)
        .filter(shading -> shading.name().toLowerCase(Locale.ROOT).equals(word.strip()))
        .findFirst()
        .orElse(UNSPECIFIED);
  }
}
