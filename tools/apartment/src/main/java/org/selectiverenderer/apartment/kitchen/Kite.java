package org.selectiverenderer.apartment.kitchen;

import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * A diamond kite of four panels, 0.75 m wide, leaning back by 14 degrees for a wall behind it, its
 * tail with bows on the floor. One of the objects that no kitchen is expected to have (thesis,
 * Appendix B).
 */
final class Kite {
  private static final double LEAN = -14;
  private static final double HALF_WIDTH = 0.375;
  private static final double CROSS = 0.62;
  private static final double HEIGHT = 0.95;

  private Kite() {}

  static ParametricModel model() {
    return ModelPlacement.centred(
        "kite",
        Part.of(
                "yellow",
                ModelMaterial.matt(ModelColour.hex(0xE3B23A)),
                panel(1, HEIGHT),
                panel(-1, 0))
            .crease(50),
        Part.of(
                "blue",
                ModelMaterial.matt(ModelColour.hex(0x3D74A6)),
                panel(-1, HEIGHT),
                panel(1, 0))
            .crease(50),
        Part.of("spars", Materials.DARK_WOOD, spars()),
        Part.of("tail", ModelMaterial.matt(ModelColour.hex(0xC4473A)), tail()).crease(60));
  }

  /** Returns a quarter of the cloth, slightly bulged, between the cross, a side and an end. */
  private static TriangleMesh panel(int side, double end) {
    TriangleMesh sheet =
        ParametricSurface.of(
            4,
            3,
            (u, v) -> {
              double x = v * u * HALF_WIDTH;
              double y = CROSS + v * (1 - u) * (end - CROSS);
              return new Vector3d(x, y, 0.16 * v * v * u * (1 - u));
            });
    TriangleMesh cloth = ParametricSurface.thicken(sheet, 0, 0, 0.002);
    return (side > 0 ? cloth : cloth.mirrorX()).turnX(LEAN);
  }

  private static TriangleMesh spars() {
    return TriangleMesh.of(
            Sweep.tube(Spine.of(0, 0, -0.006, 0, HEIGHT, -0.006), 0.006, 6),
            Sweep.tube(Spine.of(-HALF_WIDTH, CROSS, -0.006, HALF_WIDTH, CROSS, -0.006), 0.006, 6))
        .turnX(LEAN);
  }

  /** Returns the tail, a ribbon in curves over the floor with a bow at every other bend. */
  private static TriangleMesh tail() {
    Spine line =
        Spine.smooth(
            3, 0, 0.02, 0.004, 0.04, 0.004, 0.04, 0.13, 0.004, 0.05, 0.2, 0.004, 0.13, 0.12, 0.004,
            0.21, 0, 0.004, 0.2, -0.12, 0.004, 0.13, -0.23, 0.004, 0.2, -0.33, 0.004, 0.16);
    double[] bows = {0.13, 0.05, 30, 0.12, 0.21, 100, -0.12, 0.13, 20, -0.33, 0.16, 70};
    TriangleMesh tail = Sweep.tube(line, 0.004, 4);
    TriangleMesh wing =
        BoxBuilder.plain(0.05, 0.012, 0.04)
            .deform(p -> p.set(p.x, p.y, p.z * (0.2 + 32 * Math.abs(p.x + 0.025))))
            .move(0.027, 0, 0);
    for (int i = 0; i < bows.length; i += 3) {
      TriangleMesh bow = wing.append(wing.mirrorX()).turnY(bows[i + 2]);
      tail = tail.append(bow.move(bows[i], 0, bows[i + 1]));
    }
    return tail;
  }
}
