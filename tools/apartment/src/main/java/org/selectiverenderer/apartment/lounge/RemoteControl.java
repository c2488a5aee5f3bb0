package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** A remote control, 0.2 m long, with its head away from the viewer. */
final class RemoteControl {
  private static final double TOP = 0.02;

  private RemoteControl() {}

  static ParametricModel model() {
    ModelMaterial body = ModelMaterial.satin(ModelColour.of(0.13, 0.13, 0.14));
    ModelMaterial grey = ModelMaterial.satin(ModelColour.of(0.62, 0.63, 0.64));
    ModelMaterial dark = ModelMaterial.glossy(ModelColour.of(0.3, 0.02, 0.03));
    return ModelPlacement.centred(
        ParametricModel.of(
            "remoteControl",
            Part.of("body", body, body()),
            Part.of("window", dark, window()),
            Part.of("digits", grey, digits()),
            Part.of("rockers", Materials.STEEL, rockers(), ring()),
            Part.of(
                "power",
                ModelMaterial.satin(ModelColour.of(0.75, 0.14, 0.12)),
                at(0.0052, -0.0145, -0.078)),
            colour("red", 0, ModelColour.of(0.72, 0.16, 0.14)),
            colour("green", 1, ModelColour.of(0.2, 0.5, 0.25)),
            colour("yellow", 2, ModelColour.of(0.85, 0.68, 0.2)),
            colour("blue", 3, ModelColour.of(0.16, 0.3, 0.6))));
  }

  /** Returns the body, a rounded bar with a waist. */
  private static TriangleMesh body() {
    SimplePolygon outline = SimplePolygon.superellipse(0.0245, 0.1, 4.5, 108);
    return ExtrudedSolid.plate(TOP, 0.0085, 18, outline).deform(RemoteControl::waist);
  }

  private static Vector3d waist(Vector3d p) {
    double z = (p.z - 0.035) / 0.05;
    return p.mul(1 - 0.13 / (1 + z * z), 1, 1);
  }

  private static TriangleMesh window() {
    return RoundSolidBuilder.superellipsoid(0.012, 0.0055, 0.006, 2.5, 3, 20, 40)
        .move(0, 0.011, -0.0955);
  }

  private static TriangleMesh at(double radius, double x, double z) {
    return button(radius, radius).move(x, TOP, z);
  }

  private static TriangleMesh button(double radiusX, double radiusZ) {
    return PushButtons.round(radiusX, 0.0024, radiusZ, 9, 48);
  }

  /** Returns the digit keys, three columns of four. */
  private static TriangleMesh digits() {
    List<TriangleMesh> all = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double x = (i % 3 - 1) * 0.0125;
      all.add(button(0.0045, 0.0033).move(x, TOP, -0.06 + i / 3 * 0.0115));
    }
    all.add(at(0.0038, 0.003, -0.078));
    all.add(at(0.0038, 0.0145, -0.078));
    return TriangleMesh.of(all);
  }

  private static Part colour(String name, int i, ModelColour colour) {
    TriangleMesh key = button(0.0036, 0.0024).move((i - 1.5) * 0.0098, TOP, 0.069);
    return Part.of(name, ModelMaterial.satin(colour), key);
  }

  /** Returns the volume and programme keys, and five keys at the lower end. */
  private static TriangleMesh rockers() {
    List<TriangleMesh> all = new ArrayList<>();
    all.add(button(0.0042, 0.0105).move(-0.0145, TOP, -0.002));
    all.add(button(0.0042, 0.0105).move(0.0145, TOP, -0.002));
    all.add(at(0.0045, 0, -0.002));
    for (int i = 0; i < 3; i++) {
      all.add(button(0.004, 0.0028).move((i - 1) * 0.0125, TOP, 0.083));
    }
    return TriangleMesh.of(all);
  }

  /** Returns the navigation ring with a key in its middle. */
  private static TriangleMesh ring() {
    TriangleMesh ring = RoundSolidBuilder.torus(0.0105, 0.0028, 80, 24).move(0, TOP, 0);
    return ring.append(button(0.0055, 0.0055).move(0, TOP, 0)).move(0, 0, 0.038);
  }
}
