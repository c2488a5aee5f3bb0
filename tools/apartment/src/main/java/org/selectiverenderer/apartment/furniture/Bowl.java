package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** A wide bowl of blue china, 0.32 m across. */
final class Bowl {

  private Bowl() {}

  static ParametricModel model() {
    Curve wall = Curve.of(0.055, 0, 0.125, 0.045, 0.16, 0.1);
    return ParametricModel.of(
        "bowl",
        Part.of("china", Looks.BLUE_CHINA, Lathe.solid(wall.line(0.152, 0.1).line(0, 0.02), 12))
            .crease(60));
  }
}
