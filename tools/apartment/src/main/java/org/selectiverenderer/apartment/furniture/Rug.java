package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Prism;

/** A rug with a border; its pieces lie side by side. */
final class Rug {
  private static final double THICK = 0.008;

  private Rug() {}

  /**
   * @param width width of the whole rug, metres, and so {@code depth}
   * @param border breadth of the border, metres
   */
  static ParametricModel model(
      String name, double width, double depth, double border, Look edge, Look field) {
    Outline whole = Outline.rectangle(width, depth);
    return ParametricModel.of(
        name,
        Part.of("border", edge, Prism.plate(THICK, 0, 0, whole, whole.inset(border))),
        Part.of("field", field, Prism.plate(THICK, 0, 0, whole.inset(border))));
  }
}
