package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.VertexWelding;

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
    return model("sofa1Pillow", Materials.TEAL_CLOTH);
  }

  static ParametricModel second() {
    return model("sofa2Pillow", Materials.RUST_CLOTH);
  }

  private static ParametricModel model(String name, ModelMaterial cloth) {
    TriangleMesh quarter =
        ParametricSurface.of(SQUARES, SQUARES, (u, v) -> new Vector3d(grid(u), grid(v), 1));
    TriangleMesh half = MeshPatterns.bothSides(quarter);
    TriangleMesh front = half.append(half.scale(1, -1, 1));
    TriangleMesh cover = VertexWelding.weld(front.append(front.mirrorZ()).deform(Pillow::plump));
    ParametricModel upright = ParametricModel.of(name, Part.of("cover", cloth, cover).crease(80));
    return ModelPlacement.centred(upright.map(mesh -> mesh.turnX(-LEAN)));
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
    double belly = DegreeMath.power(Math.max(0, fromX * fromY), 0.55);
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
