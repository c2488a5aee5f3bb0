package org.selectiverenderer.schema;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A property of a picture in which the versions of an object may differ. The thesis varies the
 * number of polygons, and proposes global illumination, shadows and the resolution of textures,
 * alone or combined (7.2).
 */
public enum Quality {
  /** The number of polygons; the quality of a Switch whose metadata names none. */
  POLYGONS,
  /** The resolution of textures. */
  TEXTURES,
  /** Where light is computed: at each pixel, at each vertex, or once for a whole face. */
  SHADING,
  /** The light: lights, shadows, or light that is stored in textures. */
  LIGHT,
  /** How often something that moves changes. */
  ANIMATION;

  /** Returns the word for the quality in the metadata and on the command line. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the quality of a word, ignoring letter case and surrounding spaces. */
  public static Optional<Quality> of(String word) {
    return Arrays.stream(values())
        .filter(quality -> quality.spelling().equals(word.strip().toLowerCase(Locale.ROOT)))
        .findFirst();
  }

  /** Returns all words, for messages: {@code polygons, textures, ... or animation}. */
  public static String spellings() {
    Quality[] all = values();
    return Arrays.stream(all)
            .limit(all.length - 1)
            .map(Quality::spelling)
            .collect(Collectors.joining(", "))
        + " or "
        + all[all.length - 1].spelling();
  }
}
