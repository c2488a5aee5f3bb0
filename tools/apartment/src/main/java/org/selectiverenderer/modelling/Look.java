package org.selectiverenderer.modelling;

import org.jspecify.annotations.Nullable;

/**
 * The fields of an X3D Material (X3D 4.0, 12.4.5), and the picture that covers it, if any.
 *
 * @param shininess 0 to 1, 128 times which is the exponent of highlights
 * @param transparency 0 opaque to 1 invisible
 */
public record Look(
    ModelColour diffuse,
    ModelColour specular,
    double shininess,
    double transparency,
    ModelColour emissive,
    @Nullable Cladding cladding) {
  private static final ModelColour BLACK = ModelColour.grey(0);

  /** Without a picture. */
  public Look(
      ModelColour diffuse,
      ModelColour specular,
      double shininess,
      double transparency,
      ModelColour emissive) {
    this(diffuse, specular, shininess, transparency, emissive, null);
  }

  /** Cloth, paper, plaster: no highlights. */
  public static Look matt(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.02), 0.1, 0, BLACK);
  }

  /** Plastic, lacquered wood: soft white highlights. */
  public static Look satin(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.25), 0.3, 0, BLACK);
  }

  /** China, glass, polished plastic: small bright highlights. */
  public static Look glossy(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.6), 0.7, 0, BLACK);
  }

  /** Metal: highlights of its own colour. */
  public static Look metal(ModelColour colour) {
    ModelColour diffuse =
        ModelColour.of(0.5 * colour.red(), 0.5 * colour.green(), 0.5 * colour.blue());
    return new Look(diffuse, colour, 0.45, 0, BLACK);
  }

  public Look transparent(double value) {
    return new Look(diffuse, specular, shininess, value, emissive, cladding);
  }

  /** Shines by itself: a lamp's bulb, a screen. */
  public Look glowing(ModelColour light) {
    return new Look(diffuse, specular, shininess, transparency, light, cladding);
  }

  /** Covered with a picture. */
  public Look clad(Cladding picture) {
    return new Look(diffuse, specular, shininess, transparency, emissive, picture);
  }
}
