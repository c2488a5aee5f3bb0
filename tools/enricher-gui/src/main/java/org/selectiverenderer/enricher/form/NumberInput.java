package org.selectiverenderer.enricher.form;

import org.selectiverenderer.enricher.text.Texts;

/** Reads lengths as authors type them: with a point, or the comma of other keyboards. */
final class NumberInput {
  private NumberInput() {}

  static Input<Double> parse(String text) {
    try {
      double value = Double.parseDouble(text.strip().replace(',', '.'));
      if (Double.isFinite(value)) {
        return new Input.Valid<>(value);
      }
    } catch (NumberFormatException e) {
      // told below, as what is not finite is
    }
    return new Input.Wrong<>(Texts.of("area.box.number", text.isBlank() ? "\u2423" : text.strip()));
  }
}
