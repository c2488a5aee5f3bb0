package org.selectiverenderer.enricher.form;

import com.formdev.flatlaf.util.UIScale;
import java.util.Set;
import javax.swing.ImageIcon;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.selectiverenderer.enricher.images.MaterialBall;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The part of a material's form that shows a ball of the material; it follows the fields. */
final class MaterialForm implements Form {
  private static final Set<String> MATERIALS =
      Set.of("Material", "PhysicalMaterial", "UnlitMaterial");

  private static final int SIDE = 96;
  private static final float[] BLACK = {0, 0, 0};

  private final EnricherSession session;
  private final DocumentElement element;
  private final JLabel ball = new JLabel();
  private final FieldParser parser = new FieldParser();

  MaterialForm(EnricherSession session, DocumentElement element) {
    this.session = session;
    this.element = element;
    ball.setName("material ball");
    ball.getAccessibleContext().setAccessibleName(Texts.of("images.ball"));
    follow();
  }

  /** Returns whether an element is a material. */
  static boolean shows(DocumentElement element) {
    return MATERIALS.contains(element.name());
  }

  @Override
  public JComponent component() {
    return ball;
  }

  @Override
  public boolean fits() {
    return true;
  }

  @Override
  public void follow() {
    DocumentElement material =
        element
            .use()
            .flatMap(name -> session.document().tree().flatMap(tree -> tree.named(name, element)))
            .orElse(element);
    ball.setIcon(new ImageIcon(MaterialBall.picture(look(material), UIScale.scale(SIDE))));
  }

  private MaterialBall.Look look(DocumentElement material) {
    double transparency = number(material, "transparency", 0);
    return switch (material.name()) {
      case "PhysicalMaterial" -> physical(material, transparency);
      case "UnlitMaterial" ->
          new MaterialBall.Look(
              BLACK, BLACK, colour(material, "emissiveColor", 1), 0, 1, transparency);
      default ->
          new MaterialBall.Look(
              colour(material, "diffuseColor", 0.8f),
              colour(material, "specularColor", 0),
              colour(material, "emissiveColor", 0),
              number(material, "ambientIntensity", 0.2),
              Math.max(1, 128 * number(material, "shininess", 0.2)),
              transparency);
    };
  }

  /** Approximates a physical material: metals have no diffuse colour and coloured highlights. */
  private MaterialBall.Look physical(DocumentElement material, double transparency) {
    float[] base = colour(material, "baseColor", 1);
    float metallic = (float) number(material, "metallic", 1);
    double roughness = Math.max(0.05, number(material, "roughness", 1));
    float gloss = (float) (1 - 0.8 * roughness);
    float[] diffuse = new float[3];
    float[] specular = new float[3];
    for (int i = 0; i < 3; i++) {
      diffuse[i] = base[i] * (1 - metallic * gloss);
      specular[i] = (0.04f * (1 - metallic) + base[i] * metallic) * (0.3f + gloss);
    }
    double exponent = Math.min(512, 2 / Math.pow(roughness, 4));
    return new MaterialBall.Look(
        diffuse, specular, colour(material, "emissiveColor", 0), 0.15, exponent, transparency);
  }

  private float[] colour(DocumentElement material, String field, float grey) {
    Object value =
        material
            .text(field)
            .map(text -> parser.parse(FieldType.SFColor, text).value())
            .orElse(null);
    return value instanceof float[] rgb ? rgb : new float[] {grey, grey, grey};
  }

  private double number(DocumentElement material, String field, double usual) {
    try {
      double value = material.text(field).map(Double::parseDouble).orElse(usual);
      return Math.max(0, Math.min(1, value));
    } catch (NumberFormatException e) {
      return usual;
    }
  }

  @Override
  public void commit() {
    // nothing is typed here
  }

  @Override
  public void dispose() {
    // holds nothing
  }
}
