package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;

/** A rug with a border; its pieces lie side by side. */
final class Rug {
  private static final double THICK = 0.008;

  private Rug() {}

  /**
   * @param width width of the whole rug, metres, and so {@code depth}
   * @param border breadth of the border, metres
   */
  static ParametricModel model(
      String name,
      double width,
      double depth,
      double border,
      ModelMaterial edge,
      ModelMaterial field) {
    SimplePolygon whole = SimplePolygon.rectangle(width, depth);
    return ParametricModel.of(
        name,
        Part.of("border", edge, ExtrudedSolid.plate(THICK, 0, 0, whole, whole.inset(border))),
        Part.of("field", field, ExtrudedSolid.plate(THICK, 0, 0, whole.inset(border))));
  }
}
