package org.selectiverenderer.modelling;

import org.jspecify.annotations.Nullable;

/**
 * The material of a part: the fields of an X3D Material (X3D 4.0, 12.4.5), and the texture that
 * covers it, if any.
 *
 * @param shininess 0 to 1; 128 times it is the exponent of specular highlights
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

  /** Creates a material without a texture. */
  public Look(
      ModelColour diffuse,
      ModelColour specular,
      double shininess,
      double transparency,
      ModelColour emissive) {
    this(diffuse, specular, shininess, transparency, emissive, null);
  }

  /** Returns a material without highlights: cloth, paper, plaster. */
  public static Look matt(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.02), 0.1, 0, BLACK);
  }

  /** Returns a material with soft white highlights: plastic, lacquered wood. */
  public static Look satin(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.25), 0.3, 0, BLACK);
  }

  /** Returns a material with small bright highlights: china, glass, polished plastic. */
  public static Look glossy(ModelColour diffuse) {
    return new Look(diffuse, ModelColour.grey(0.6), 0.7, 0, BLACK);
  }

  /** Returns a metal, with highlights of its own colour. */
  public static Look metal(ModelColour colour) {
    ModelColour diffuse =
        ModelColour.of(0.5 * colour.red(), 0.5 * colour.green(), 0.5 * colour.blue());
    return new Look(diffuse, colour, 0.45, 0, BLACK);
  }

  public Look transparent(double value) {
    return new Look(diffuse, specular, shininess, value, emissive, cladding);
  }

  /** Returns this material with an emissive colour: a lamp's bulb, a screen. */
  public Look glowing(ModelColour light) {
    return new Look(diffuse, specular, shininess, transparency, light, cladding);
  }

  /** Returns this material covered with a texture. */
  public Look clad(Cladding picture) {
    return new Look(diffuse, specular, shininess, transparency, emissive, picture);
  }
}
