package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * A farmhouse table for four, 1.4 m wide and 0.75 m high: oak top, painted turned legs, a drawer.
 */
final class KitchenTable {
  private static final double WIDTH = 1.4;
  private static final double DEPTH = 0.8;
  private static final double LEG_X = WIDTH / 2 - 0.075;
  private static final double LEG_Z = DEPTH / 2 - 0.075;

  private KitchenTable() {}

  static ParametricModel model() {
    TriangleMesh longApron = BoxBuilder.plain(2 * LEG_X, 0.11, 0.022).move(0, 0.61, 0);
    TriangleMesh shortApron = BoxBuilder.plain(0.022, 0.11, 2 * LEG_Z).move(0, 0.61, 0);
    return ModelPlacement.centred(
        "kitchenTable",
        Part.of("top", Materials.LIGHT_OAK, top()),
        Part.of(
            "frame",
            ModelMaterial.satin(ModelColour.hex(0xDDD8CC)),
            MeshPatterns.corners(leg(), LEG_X, LEG_Z),
            longApron.move(0, 0, LEG_Z).append(longApron.move(0, 0, -LEG_Z)),
            MeshPatterns.bothSides(shortApron.move(LEG_X, 0, 0)),
            BoxBuilder.bevelled(0.42, 0.08, 0.016, 0.006, 1).move(0, 0.622, LEG_Z + 0.014)),
        Part.of("knob", Materials.DARK_STEEL, knob()));
  }

  private static TriangleMesh top() {
    SimplePolygon seenFromAbove = SimplePolygon.roundedRectangle(WIDTH, DEPTH, 0.04, 3);
    return RoundedSlabs.lying(seenFromAbove, 0.032, 0.011, 3).move(0, 0.718, 0);
  }

  /** Returns a leg with a square block where the apron meets it, turned below. */
  private static TriangleMesh leg() {
    ProfileCurve turned =
        ProfileCurve.of(0.02, 0, 0.024, 0.012, 0.021, 0.06)
            .line(0.031, 0.085)
            .line(0.022, 0.11)
            .spline(2, 0.027, 0.26, 0.036, 0.42, 0.03, 0.52)
            .line(0.024, 0.545)
            .line(0.036, 0.56)
            .line(0.036, 0.575)
            .line(0.026, 0.588)
            .line(0.026, 0.6);
    return Lathe.solid(turned, 14)
        .append(BoxBuilder.bevelled(0.075, 0.125, 0.075, 0.006, 1).move(0, 0.594, 0));
  }

  private static TriangleMesh knob() {
    ProfileCurve profile =
        ProfileCurve.of(0, 0, 0.007, 0, 0.007, 0.01, 0.0145, 0.02, 0.011, 0.027, 0, 0.029);
    return Lathe.solid(profile, 14).turnX(90).move(0, 0.662, LEG_Z + 0.022);
  }
}
