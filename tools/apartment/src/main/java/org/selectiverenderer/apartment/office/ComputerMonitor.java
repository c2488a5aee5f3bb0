package org.selectiverenderer.apartment.office;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A flat screen with a desktop and a window on it, 0.52 m wide, for a {@link ComputerSet}. */
final class ComputerMonitor {
  private static final double HEIGHT = 0.3;

  private ComputerMonitor() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "monitor",
        Part.of("frame", Materials.BLACK, frame(), back(), neck()),
        Part.of("stand", Materials.CHARCOAL, stand()),
        Part.of("monitorLamp", Materials.lit(0.25, 0.6, 1), lamp()),
        Part.of("desktop", Materials.lit(0.14, 0.34, 0.52), screen(0.484, 0.284, 0, 0, 1)),
        Part.of("taskBar", Materials.lit(0.07, 0.12, 0.2), screen(0.484, 0.016, 0, -0.134, 2)),
        Part.of(
            "window",
            Materials.lit(0.88, 0.89, 0.9),
            screen(0.25, 0.17, 0.05, 0.0, 2),
            icon(0),
            icon(1),
            icon(2)),
        Part.of("windowTitle", Materials.lit(0.85, 0.5, 0.15), screen(0.25, 0.016, 0.05, 0.085, 3)),
        Part.of("writing", Materials.lit(0.25, 0.27, 0.3), writing()));
  }

  private static TriangleMesh frame() {
    return ExtrudedSolid.bevelled(
            0.026,
            0.006,
            5,
            SimplePolygon.roundedRectangle(0.52, 0.32, 0.012, 6),
            SimplePolygon.roundedRectangle(0.482, 0.282, 0.002, 2))
        .move(0, HEIGHT, 0);
  }

  private static TriangleMesh back() {
    return BoxBuilder.bevelled(0.5, 0.3, 0.03, 0.01, 4)
        .move(0, HEIGHT - 0.15, -0.001)
        .append(BoxBuilder.bevelled(0.2, 0.18, 0.04, 0.014, 5).move(0, HEIGHT - 0.1, -0.03));
  }

  private static TriangleMesh neck() {
    return BoxBuilder.bevelled(0.06, 0.2, 0.022, 0.009, 5).move(0, 0.012, -0.04);
  }

  private static TriangleMesh stand() {
    return ExtrudedSolid.plate(0.014, 0.006, 5, SimplePolygon.ellipse(0.13, 0.09, 80))
        .move(0, 0, -0.03);
  }

  private static TriangleMesh lamp() {
    return MeshOrientation.forward(RoundSolidBuilder.cylinder(0.0025, 0.001, 16))
        .move(0.235, HEIGHT - 0.1505, 0.026);
  }

  private static TriangleMesh writing() {
    TriangleMesh lines = TriangleMesh.EMPTY;
    for (int i = 0; i < 8; i++) {
      double width = i % 4 == 3 ? 0.12 : 0.21;
      lines = lines.append(screen(width, 0.006, 0.05 - (0.21 - width) / 2, 0.055 - 0.017 * i, 3));
    }
    return lines;
  }

  private static TriangleMesh icon(int row) {
    return screen(0.026, 0.026, -0.2, 0.105 - 0.048 * row, 2);
  }

  /** Returns a rectangle of the screen; higher layers lie in front of lower ones. */
  private static TriangleMesh screen(double width, double height, double x, double y, int layer) {
    return MeshOrientation.flat(width, height)
        .move(x, HEIGHT + y, 0.0165 + 0.0004 * layer + 0.0005);
  }
}
