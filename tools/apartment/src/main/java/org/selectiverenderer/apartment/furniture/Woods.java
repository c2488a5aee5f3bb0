package org.selectiverenderer.apartment.furniture;

import org.selectiverenderer.apartment.pictures.Pictures;
import org.selectiverenderer.modelling.Cladding;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ModelColour;

/** Wood materials with a texture of their grain. */
final class Woods {
  /** The veneer of the rooms' doors, with the grain upright. */
  static final Look VENEER =
      Look.satin(ModelColour.grey(1))
          .clad(Cladding.metric(Pictures.VENEER, Pictures.VENEER_WIDTH, Pictures.VENEER_HEIGHT));

  private Woods() {}
}
