package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.TextGeometry;

/** A mobile phone with keys, of the thesis's time, lying on its back, 0.112 m long. */
final class Mobile {
  private static final double FACE = 0.0185;
  private static final String KEYS = "123456789*0#";

  private Mobile() {}

  static ParametricModel model() {
    ModelMaterial shell = ModelMaterial.satin(ModelColour.of(0.5, 0.54, 0.6));
    ModelMaterial face = ModelMaterial.glossy(ModelColour.of(0.08, 0.09, 0.11));
    ModelMaterial keys = ModelMaterial.satin(ModelColour.of(0.78, 0.8, 0.82));
    ModelMaterial screen =
        ModelMaterial.glossy(ModelColour.of(0.35, 0.6, 0.66))
            .glowing(ModelColour.of(0.1, 0.2, 0.23));
    ModelMaterial ink = ModelMaterial.matt(ModelColour.of(0.1, 0.11, 0.13));
    ModelMaterial green = ModelMaterial.satin(ModelColour.of(0.2, 0.52, 0.24));
    ModelMaterial red = ModelMaterial.satin(ModelColour.of(0.66, 0.15, 0.13));
    return ModelPlacement.centred(
        ParametricModel.of(
            "mobile",
            Part.of("shell", shell, shell()),
            Part.of("face", face, face()),
            Part.of("screen", screen, screen()),
            Part.of("keys", keys, keys(), navigation(), ear()),
            Part.of("call", green, key(0.006, 0.0034).move(-0.0138, FACE, 0.0035)),
            Part.of("hangUp", red, key(0.006, 0.0034).move(0.0138, FACE, 0.0035)),
            Part.of("digits", ink, digits())));
  }

  private static TriangleMesh shell() {
    SimplePolygon outline = SimplePolygon.superellipse(0.0235, 0.056, 3.4, 72);
    TriangleMesh antenna =
        RoundSolidBuilder.capsule(0.0032, 0.026, 6, 16).turnX(-90).move(0.0145, 0.01, -0.04);
    return ExtrudedSolid.plate(0.0175, 0.0065, 9, outline).append(antenna);
  }

  private static TriangleMesh face() {
    SimplePolygon outline = SimplePolygon.superellipse(0.0198, 0.0515, 3.4, 72);
    return ExtrudedSolid.plate(0.0035, 0.0015, 3, outline).move(0, FACE - 0.0035, 0);
  }

  private static TriangleMesh screen() {
    SimplePolygon outline = SimplePolygon.roundedRectangle(0.031, 0.034, 0.003, 6);
    return ExtrudedSolid.plate(0.0012, 0.0005, 2, outline).move(0, FACE - 0.0004, -0.0205);
  }

  private static TriangleMesh key(double radiusX, double radiusZ) {
    return PushButtons.round(radiusX, 0.0016, radiusZ, 5, 32);
  }

  private static double x(int key) {
    return (key % 3 - 1) * 0.0125;
  }

  private static double z(int key) {
    return 0.0135 + key / 3 * 0.0088;
  }

  private static TriangleMesh keys() {
    List<TriangleMesh> all = new ArrayList<>();
    for (int key = 0; key < KEYS.length(); key++) {
      all.add(key(0.0054, 0.0034).move(x(key), FACE, z(key)));
    }
    return TriangleMesh.of(all);
  }

  /** Returns the navigation key, a rocker in a ring below the screen. */
  private static TriangleMesh navigation() {
    return RoundSolidBuilder.torus(0.0058, 0.0011, 40, 10)
        .append(PushButtons.round(0.0036, 0.0012, 0.0036, 5, 32))
        .move(0, FACE, 0.0035);
  }

  private static TriangleMesh ear() {
    TriangleMesh slot = RoundSolidBuilder.capsule(0.0006, 0.004, 4, 12).turnX(-90);
    return MeshPatterns.row(slot.move(-0.0048, FACE, -0.0405), 5, 0.0024, 0, 0);
  }

  private static TriangleMesh digits() {
    TextGeometry lettering = TextGeometry.bold();
    List<TriangleMesh> all = new ArrayList<>();
    for (int key = 0; key < KEYS.length(); key++) {
      TriangleMesh digit = lettering.flat(KEYS.substring(key, key + 1), 0.0058).turnX(-90);
      all.add(digit.move(x(key), FACE + 0.0018, z(key)));
    }
    return TriangleMesh.of(all);
  }
}
