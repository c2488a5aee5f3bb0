package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalText;

/**
 * Converts a material to the fields of an X3D Material, with default values (X3D 3.3, 12.4.4) left
 * out.
 */
final class LookFields {

  private LookFields() {}

  /** Returns field names and values in turn. */
  static String[] fields(Look look) {
    List<String> fields = new ArrayList<>();
    field(fields, "diffuseColor", colour(look.diffuse()), "0.8 0.8 0.8");
    field(fields, "specularColor", colour(look.specular()), "0 0 0");
    field(fields, "shininess", DecimalText.rounded(look.shininess(), 3), "0.2");
    field(fields, "transparency", DecimalText.rounded(look.transparency(), 3), "0");
    field(fields, "emissiveColor", colour(look.emissive()), "0 0 0");
    return fields.toArray(String[]::new);
  }

  private static void field(List<String> fields, String name, String value, String standard) {
    if (!value.equals(standard)) {
      fields.addAll(List.of(name, value));
    }
  }

  private static String colour(ModelColour colour) {
    return DecimalText.rounded(colour.red(), 3)
        + " "
        + DecimalText.rounded(colour.green(), 3)
        + " "
        + DecimalText.rounded(colour.blue(), 3);
  }
}
