package org.selectiverenderer.enricher.form;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import javax.swing.UIManager;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/** A button that shows an SFColor (X3D 4.0, 5.3.4: RGB from 0 to 1) and asks for another one. */
final class ColorSwatch extends JButton {
  private static final long serialVersionUID = 1L;
  private static final int SIDE = 18;

  private final transient Supplier<String> text;

  /**
   * @param text the colour as X3D text; an invalid one is shown as the background
   * @param chosen called with the colour that the author chooses
   */
  ColorSwatch(String name, Supplier<String> text, Function<String, Optional<String>> chosen) {
    this.text = text;
    setName("swatch " + name);
    setToolTipText(Texts.of("fields.colour", name));
    getAccessibleContext().setAccessibleName(Texts.of("fields.colour", name));
    setPreferredSize(new Dimension(SIDE + 8, SIDE));
    addActionListener(
        event -> {
          Color now = colour().orElse(Color.WHITE);
          Color picked =
              JColorChooser.showDialog(this, Texts.of("fields.colour", name), now, false);
          if (picked != null) {
            chosen.apply(written(picked));
          }
        });
  }

  static String written(Color colour) {
    return part(colour.getRed()) + " " + part(colour.getGreen()) + " " + part(colour.getBlue());
  }

  /** Formats a component with three decimals, which distinguish all 256 steps. */
  private static String part(int of255) {
    String digits = String.format(Locale.ROOT, "%.3f", of255 / 255.0);
    return digits.replaceFirst("0+$", "").replaceFirst("\\.$", "");
  }

  private Optional<Color> colour() {
    boolean some = !text.get().isBlank();
    Object value = some ? new FieldParser().parse(FieldType.SFColor, text.get()).value() : null;
    return value instanceof float[] rgb
        ? Optional.of(new Color(unit(rgb[0]), unit(rgb[1]), unit(rgb[2])))
        : Optional.empty();
  }

  private static float unit(float part) {
    return part >= 0 ? Math.min(1, part) : 0;
  }

  @Override
  protected void paintComponent(Graphics g) {
    int top = (getHeight() - SIDE + 4) / 2;
    g.setColor(colour().orElse(UIManager.getColor("Panel.background")));
    g.fillRect(4, top, getWidth() - 8, SIDE - 4);
    g.setColor(UIManager.getColor("Component.borderColor"));
    g.drawRect(4, top, getWidth() - 8, SIDE - 4);
  }
}
