package org.selectiverenderer.modelling;

import org.jspecify.annotations.Nullable;

/**
 * The material of a part: the fields of an X3D Material (X3D 4.0, 12.4.5), and the texture that
 * covers it, if any.
 *
 * @param shininess 0 to 1; 128 times it is the exponent of specular highlights
 * @param transparency 0 opaque to 1 invisible
 */
public record ModelMaterial(
    ModelColour diffuse,
    ModelColour specular,
    double shininess,
    double transparency,
    ModelColour emissive,
    @Nullable TextureMapping cladding) {
  private static final ModelColour BLACK = ModelColour.grey(0);

  /** Creates a material without a texture. */
  public ModelMaterial(
      ModelColour diffuse,
      ModelColour specular,
      double shininess,
      double transparency,
      ModelColour emissive) {
    this(diffuse, specular, shininess, transparency, emissive, null);
  }

  /** Returns a material without highlights: cloth, paper, plaster. */
  public static ModelMaterial matt(ModelColour diffuse) {
    return new ModelMaterial(diffuse, ModelColour.grey(0.02), 0.1, 0, BLACK);
  }

  /** Returns a material with soft white highlights: plastic, lacquered wood. */
  public static ModelMaterial satin(ModelColour diffuse) {
    return new ModelMaterial(diffuse, ModelColour.grey(0.25), 0.3, 0, BLACK);
  }

  /** Returns a material with small bright highlights: china, glass, polished plastic. */
  public static ModelMaterial glossy(ModelColour diffuse) {
    return new ModelMaterial(diffuse, ModelColour.grey(0.6), 0.7, 0, BLACK);
  }

  /** Returns a metal, with highlights of its own colour. */
  public static ModelMaterial metal(ModelColour colour) {
    ModelColour diffuse =
        ModelColour.of(0.5 * colour.red(), 0.5 * colour.green(), 0.5 * colour.blue());
    return new ModelMaterial(diffuse, colour, 0.45, 0, BLACK);
  }

  public ModelMaterial transparent(double value) {
    return new ModelMaterial(diffuse, specular, shininess, value, emissive, cladding);
  }

  /** Returns this material with an emissive colour: a lamp's bulb, a screen. */
  public ModelMaterial glowing(ModelColour light) {
    return new ModelMaterial(diffuse, specular, shininess, transparency, light, cladding);
  }

  /** Returns this material covered with a texture. */
  public ModelMaterial clad(TextureMapping picture) {
    return new ModelMaterial(diffuse, specular, shininess, transparency, emissive, picture);
  }
}
