package org.selectiverenderer.apartment.office;

import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;

/**
 * A plastic trash can with three ribs and a rolled rim, 0.32 m high and 0.306 m wide: 28 steps of a
 * profile with 18 bands and two centres, 28 * (18 * 2 + 2) = 1064 triangles (thesis Fig 71).
 */
final class TrashCan {

  private TrashCan() {}

  static Model model() {
    Curve ribbedWall =
        Curve.of(0.106, 0, 0.111, 0.004)
            .line(0.1165, 0.054)
            .line(0.1235, 0.064)
            .line(0.1187, 0.074)
            .line(0.1262, 0.142)
            .line(0.1332, 0.152)
            .line(0.1284, 0.162)
            .line(0.1359, 0.230)
            .line(0.1429, 0.240)
            .line(0.1381, 0.250);
    Curve rolledRim =
        Curve.of(0.1430, 0.295, 0.1515, 0.3, 0.153, 0.311, 0.1465, 0.32, 0.1385, 0.314);
    Curve inside = Curve.of(0.138, 0.296, 0.108, 0.016, 0.1, 0.008);
    Curve profile = ribbedWall.then(rolledRim).then(inside);
    Look plastic = new Look(Colour.of(0.3, 0.42, 0.5), Colour.grey(0.35), 0.35, 0, Colour.grey(0));
    return Model.of("trashCan", Part.of("body", plastic, Lathe.solid(profile, 28)));
  }
}
