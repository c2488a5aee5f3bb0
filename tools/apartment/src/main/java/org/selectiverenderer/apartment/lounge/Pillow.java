package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.looks.Looks;
import org.selectiverenderer.geometry.Degrees;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Copies;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Sheet;
import org.selectiverenderer.modelling.Standing;
import org.selectiverenderer.modelling.Welding;

/**
 * A square pillow with a piped seam, drawn in by a stitch in the middle of both sides. It stands
 * and leans back, as against the back of a sofa: eight sheets of 16 by 16 squares, 4096 triangles.
 */
final class Pillow {
  private static final double HALF = 0.225;
  private static final double THICK = 0.085;
  private static final int SQUARES = 16;

  /** Inner edge of the piping, as a share of half the width. */
  private static final double PIPING = 0.965;

  private static final double LEAN = 17;

  private Pillow() {}

  static ParametricModel first() {
    return model("sofa1Pillow", Looks.TEAL_CLOTH);
  }

  static ParametricModel second() {
    return model("sofa2Pillow", Looks.RUST_CLOTH);
  }

  private static ParametricModel model(String name, Look cloth) {
    TriangleMesh quarter = Sheet.of(SQUARES, SQUARES, (u, v) -> new Vector3d(grid(u), grid(v), 1));
    TriangleMesh half = Copies.bothSides(quarter);
    TriangleMesh front = half.append(half.scale(1, -1, 1));
    TriangleMesh cover = Welding.weld(front.append(front.mirrorZ()).deform(Pillow::plump));
    ParametricModel upright = ParametricModel.of(name, Part.of("cover", cloth, cover).crease(80));
    return Standing.centred(upright.map(mesh -> mesh.turnX(-LEAN)));
  }

  /**
   * Returns the position of a grid line, 0 in the middle to 1 at the edge; the outermost squares
   * are the piping.
   */
  private static double grid(double t) {
    long line = Math.round(SQUARES * t);
    return line == SQUARES ? 1 : PIPING * line / (SQUARES - 1);
  }

  /** Maps a point of the square from -1 to 1 on a side (z = 1 or -1) to the pillow. */
  private static Vector3d plump(Vector3d p) {
    double fromX = 1 - p.x * p.x;
    double fromY = 1 - p.y * p.y;
    double belly = Degrees.power(Math.max(0, fromX * fromY), 0.55);
    double square = (p.x * p.x + p.y * p.y) * HALF * HALF;
    double dent = 0.62 / (1 + square / (0.045 * 0.045));
    double rim = Math.max(Math.abs(p.x), Math.abs(p.y));
    double seam = rim > 0.999 ? 0 : rim > PIPING - 0.001 ? 0.007 : 0;
    double thick = Math.max(seam, THICK * belly * (1 - dent));
    // The edges are drawn in between the corners.
    return new Vector3d(
        HALF * p.x * (1 - 0.035 * fromY), HALF * p.y * (1 - 0.035 * fromX), p.z * thick);
  }
}
