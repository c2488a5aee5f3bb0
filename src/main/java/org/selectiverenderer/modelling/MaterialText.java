package org.selectiverenderer.modelling;

/** A look as a Material element, its defaults (X3D 3.3, 12.4.4) left out. */
final class MaterialText {

  private MaterialText() {}

  static String of(Look look) {
    StringBuilder text = new StringBuilder("<Material");
    field(text, "diffuseColor", colour(look.diffuse()), "0.8 0.8 0.8");
    field(text, "specularColor", colour(look.specular()), "0 0 0");
    field(text, "shininess", DecimalText.of(look.shininess(), 3), "0.2");
    field(text, "transparency", DecimalText.of(look.transparency(), 3), "0");
    field(text, "emissiveColor", colour(look.emissive()), "0 0 0");
    return text.append("/>").toString();
  }

  private static void field(StringBuilder text, String name, String value, String standard) {
    if (!value.equals(standard)) {
      text.append(' ').append(name).append("='").append(value).append('\'');
    }
  }

  private static String colour(Colour colour) {
    return DecimalText.of(colour.red(), 3)
        + " "
        + DecimalText.of(colour.green(), 3)
        + " "
        + DecimalText.of(colour.blue(), 3);
  }
}
