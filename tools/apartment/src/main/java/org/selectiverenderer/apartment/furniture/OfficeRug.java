package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Prism;

/** A rug with a border, 2.2 m by 1.5 m; its pieces lie side by side. */
final class OfficeRug {
  private static final double THICK = 0.008;

  private OfficeRug() {}

  static ParametricModel model() {
    Outline edge = Outline.rectangle(2.2, 1.5);
    return ParametricModel.of(
        "officeRug",
        Part.of("border", Looks.RUST_CLOTH, Prism.plate(THICK, 0, 0, edge, edge.inset(0.1))),
        Part.of("field", Looks.LINEN, Prism.plate(THICK, 0, 0, edge.inset(0.1))));
  }
}
