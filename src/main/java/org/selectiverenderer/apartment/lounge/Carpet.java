package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Extrusion;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.TriangleMesh;

/** A carpet, 2.6 m by 1.8 m without its fringes, with a border and three lozenges. */
final class Carpet {
  private static final double WIDTH = 2.6;
  private static final double DEPTH = 1.8;
  private static final double THICK = 0.009;
  private static final double STRIPE = 0.0025;

  private Carpet() {}

  static Model model() {
    TriangleMesh lozenge = inlay(0.0115, Outline.of(0.34, 0, 0, 0.5, -0.34, 0, 0, -0.5));
    TriangleMesh eye = inlay(0.014, Outline.of(0.15, 0, 0, 0.22, -0.15, 0, 0, -0.22));
    return Model.of(
        "carpet",
        Part.of("pile", Looks.TEAL_CLOTH, Boxes.plain(WIDTH, THICK, DEPTH)),
        Part.of("border", Looks.CREAM_CLOTH, frame(0.1, 0.05), frame(0.26, 0.02)),
        Part.of(
            "lozenges", Looks.CREAM_CLOTH, Copies.row(lozenge.move(-0.72, 0, 0), 3, 0.72, 0, 0)),
        Part.of("eyes", Looks.RUST_CLOTH, Copies.row(eye.move(-0.72, 0, 0), 3, 0.72, 0, 0)),
        Part.of("fringes", Looks.CREAM_CLOTH, Copies.bothSides(fringe())));
  }

  private static TriangleMesh frame(double inset, double width) {
    Outline outer = Outline.rectangle(WIDTH - 2 * inset, DEPTH - 2 * inset);
    return Extrusion.plate(THICK + STRIPE, 0, 0, outer, outer.inset(width));
  }

  private static TriangleMesh inlay(double height, Outline outline) {
    return Extrusion.plate(height, 0, 0, outline);
  }

  /** Tufts at the right end, each a flat triangle. */
  private static TriangleMesh fringe() {
    float x = (float) WIDTH / 2;
    float[] corners = {x, 0.004f, 0.028f, x + 0.06f, 0.001f, 0.004f, x, 0.004f, -0.028f};
    TriangleMesh tuft = new TriangleMesh(corners, new int[] {0, 1, 2});
    return Copies.row(tuft.move(0, 0, 0.03 - DEPTH / 2), 30, 0, 0, 0.06);
  }
}
