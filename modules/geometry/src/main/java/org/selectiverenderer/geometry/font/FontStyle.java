package org.selectiverenderer.geometry.font;

import java.util.Optional;

/** The values of the field {@code style} of the FontStyle node (X3D 4.0, 15.4.1). */
public enum FontStyle {
  /** Upright, of normal weight. */
  PLAIN,
  /** Upright and bold. */
  BOLD,
  /** Italic or oblique. */
  ITALIC,
  /** Bold and italic or oblique. */
  BOLDITALIC;

  /** Returns the style of that name; the empty name means PLAIN. */
  public static Optional<FontStyle> of(String name) {
    if (name.isEmpty()) {
      return Optional.of(PLAIN);
    }
    for (FontStyle style : values()) {
      if (style.name().equals(name)) {
        return Optional.of(style);
      }
    }
    return Optional.empty();
  }
}
