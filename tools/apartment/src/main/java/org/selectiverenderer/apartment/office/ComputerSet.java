package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A desktop computer: tower on the left, screen, keyboard and mouse, 0.9 m wide (thesis Fig 71).
 */
final class ComputerSet {

  private ComputerSet() {}

  static ParametricModel model() {
    ParametricModel tower = Tower.model().map(mesh -> mesh.move(-0.4, 0, 0.03));
    ParametricModel monitor = ComputerMonitor.model().map(mesh -> mesh.move(0, 0, -0.12));
    ParametricModel keyboard = Keyboard.model().map(mesh -> mesh.move(-0.04, 0, 0.2));
    return ModelPlacement.centred(
        tower.plus(monitor).plus(keyboard).plus(mouse()).named("computerSet"));
  }

  /** Returns the mouse on a mat to the right of the keyboard, its buttons to the screen. */
  private static ParametricModel mouse() {
    MouseShape shape = new MouseShape(28, 40);
    TriangleMesh mat =
        ExtrudedSolid.plate(0.003, 0.001, 2, SimplePolygon.roundedRectangle(0.2, 0.19, 0.014, 6));
    TriangleMesh cable =
        shape.cable(8, 10, 0.005, 0.001, 0.1, 0.02, 0, 0.15, 0.035, 0, 0.22, 0.08, 0, 0.32);
    ParametricModel mouse =
        ParametricModel.of(
            "mouse",
            Part.of("mousePalm", Materials.CHARCOAL, shape.palm()).crease(60),
            Part.of("mouseButtons", Materials.BLACK, shape.buttons()).crease(60),
            Part.of("mouseSeam", Materials.GREY, shape.seam(12)),
            Part.of("mouseWheel", Materials.GREY, shape.wheel(24, 10)),
            Part.of("mouseCable", Materials.RUBBER, cable));
    return mouse
        .map(mesh -> mesh.turnY(175).move(0.31, 0.003, 0.2))
        .plus(ParametricModel.of("mat", Part.of("mat", Materials.BLUE, mat.move(0.31, 0, 0.19))));
  }
}
