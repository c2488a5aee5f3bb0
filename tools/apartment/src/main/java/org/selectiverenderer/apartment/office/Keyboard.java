package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A full keyboard, 0.45 m wide, for a {@link ComputerSet}. */
final class Keyboard {
  private static final double PITCH = 0.0188;
  private static final double WIDTH = 22.75 * PITCH;

  private Keyboard() {}

  static ParametricModel model() {
    TriangleMesh keys =
        keys(KeyboardLayout.MAIN).append(keys(KeyboardLayout.RIGHT).move(15 * PITCH, 0, 0));
    TriangleMesh body =
        ExtrudedSolid.plate(
            0.018,
            0.005,
            4,
            SimplePolygon.roundedRectangle(WIDTH + 0.022, 6 * PITCH + 0.03, 0.01, 7));
    TriangleMesh lamps =
        MeshPatterns.row(RoundSolidBuilder.cylinder(0.002, 0.001, 10), 3, 0.012, 0, 0)
            .move(WIDTH / 2 - 0.065, 0.018, -2.6 * PITCH);
    ParametricModel flat =
        ParametricModel.of(
            "keyboard",
            Part.of("keyboardBody", Materials.BLACK, body),
            Part.of("keys", Materials.CHARCOAL, keys.move(-WIDTH / 2, 0.015, -3 * PITCH)),
            Part.of("keyboardLamps", Materials.lit(0.2, 0.8, 0.3), lamps));
    return flat.map(mesh -> mesh.turnX(4).move(0, 0.005, 0));
  }

  private static TriangleMesh keys(double[][] rows) {
    return KeyboardLayout.of(
        rows,
        PITCH,
        PITCH,
        width -> BoxBuilder.bevelled(width - 0.0018, 0.010, PITCH - 0.0018, 0.003, 2));
  }
}
