package org.selectiverenderer.enricher.form;

import org.selectiverenderer.enricher.text.Texts;

/** Parses lengths with a decimal point or a decimal comma. */
final class NumberInput {
  private NumberInput() {}

  static Input<Double> parse(String text) {
    try {
      double value = Double.parseDouble(text.strip().replace(',', '.'));
      if (Double.isFinite(value)) {
        return new Input.Valid<>(value);
      }
    } catch (NumberFormatException e) {
      // reported below, together with values that are not finite
    }
    return new Input.Wrong<>(Texts.of("area.box.number", text.isBlank() ? "\u2423" : text.strip()));
  }
}
