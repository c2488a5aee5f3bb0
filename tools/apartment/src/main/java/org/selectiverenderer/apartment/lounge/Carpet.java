package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Prism;

/**
 * A carpet, 2.6 m by 1.8 m without its fringes, with two stripes and three lozenges. The pattern's
 * pieces lie side by side, so that none fights with another for the same depth.
 */
final class Carpet {
  private static final double THICK = 0.009;
  private static final Outline EDGE = Outline.rectangle(2.6, 1.8);
  private static final double APART = 0.68;

  private Carpet() {}

  static ParametricModel model() {
    Outline lozenge = Outline.of(0.31, 0, 0, 0.5, -0.31, 0, 0, -0.5);
    Outline eye = Outline.of(0.14, 0, 0, 0.21, -0.14, 0, 0, -0.21);
    Outline third = Outline.rectangle(APART, 1.24);
    return ParametricModel.of(
        "carpet",
        Part.of("rim", Looks.TEAL_CLOTH, Prism.plate(THICK, 0, 0, EDGE, EDGE.inset(0.1))),
        Part.of("stripes", Looks.CREAM_CLOTH, frame(0.1, 0.15), frame(0.26, 0.28)),
        Part.of("field", Looks.TEAL_CLOTH, frame(0.15, 0.26), three(top(third, lozenge))),
        Part.of("lozenges", Looks.CREAM_CLOTH, three(top(lozenge, eye))),
        Part.of("eyes", Looks.RUST_CLOTH, three(top(eye))),
        Part.of("fringes", Looks.CREAM_CLOTH, Copies.bothSides(fringe())));
  }

  private static TriangleMesh frame(double from, double to) {
    return top(EDGE.inset(from), EDGE.inset(to));
  }

  private static TriangleMesh top(Outline outline, Outline... holes) {
    TriangleMesh plate = Prism.plate(THICK, 0, 0, outline, holes);
    return CutPieces.where(plate, p -> p.y > 0.9 * THICK);
  }

  private static TriangleMesh three(TriangleMesh piece) {
    return Copies.row(piece.move(-APART, 0, 0), 3, APART, 0, 0);
  }

  /** Tufts at the right end, each a flat triangle. */
  private static TriangleMesh fringe() {
    float[] corners = {1.3f, 0.004f, 0.028f, 1.36f, 0.001f, 0.004f, 1.3f, 0.004f, -0.028f};
    TriangleMesh tuft = new TriangleMesh(corners, new int[] {0, 1, 2});
    return Copies.row(tuft.move(0, 0, -0.87), 30, 0, 0, 0.06);
  }
}
