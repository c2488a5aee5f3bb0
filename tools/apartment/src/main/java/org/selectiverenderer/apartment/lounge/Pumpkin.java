package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A pumpkin with a lit face, as for Halloween; nobody expects it in a lounge. */
final class Pumpkin {
  private static final double RADIUS = 0.14;
  private static final double FLAT = 0.8;

  private Pumpkin() {}

  static ParametricModel model() {
    ModelMaterial skin = ModelMaterial.satin(ModelColour.of(0.82, 0.4, 0.08));
    ModelMaterial lit =
        ModelMaterial.matt(ModelColour.of(1, 0.8, 0.3)).glowing(ModelColour.of(0.95, 0.68, 0.18));
    ModelMaterial stalk = ModelMaterial.matt(ModelColour.of(0.36, 0.4, 0.18));
    TriangleMesh body =
        RoundSolidBuilder.ellipsoid(RADIUS, FLAT * RADIUS, RADIUS, 10, 30).deform(Pumpkin::ribbed);
    return ModelPlacement.centred(
        ParametricModel.of(
            "pumpkin",
            Part.of("skin", skin, body).crease(60),
            Part.of("face", lit, face()),
            Part.of("stalk", stalk, stalk())));
  }

  /** Deforms a sphere to ten ribs with a hollow at the stalk and below. */
  private static Vector3d ribbed(Vector3d p) {
    double level = Math.sqrt(p.x * p.x + p.z * p.z) / RADIUS;
    double ribs = 1 + 0.045 * level * DegreeMath.cos(10 * DegreeMath.atan2(p.x, p.z));
    double hollow = 1 - 0.3 / (1 + 20 * level * level);
    return p.mul(ribs, hollow, ribs);
  }

  /** Returns the face, drawn flat in millimetres, then projected on the pumpkin. */
  private static TriangleMesh face() {
    SimplePolygon eye = SimplePolygon.of(20, 22, 66, 22, 43, 62);
    SimplePolygon nose = SimplePolygon.of(-12, -2, 12, -2, 0, 18);
    SimplePolygon mouth =
        SimplePolygon.of(
            -72, -14, -52, -40, -36, -48, -30, -36, -20, -52, 20, -52, 30, -36, 36, -48, 52, -40,
            72, -14, 46, -26, 20, -34, 12, -24, 0, -36, -12, -24, -20, -34, -46, -26);
    return TriangleMesh.of(shape(eye), shape(eye.scale(-1, 1)), shape(nose), shape(mouth));
  }

  private static TriangleMesh shape(SimplePolygon millimetres) {
    return ExtrudedSolid.plain(0.012, millimetres.scale(0.001, 0.001)).deform(Pumpkin::onSkin);
  }

  /** Maps a point of the flat face to the skin; z is its distance outside of the skin. */
  private static Vector3d onSkin(Vector3d p) {
    double y = p.y / (FLAT * RADIUS);
    double x = p.x / RADIUS;
    double z = RADIUS * Math.sqrt(Math.max(0.05, 1 - x * x - y * y));
    return p.set(p.x, p.y, z + p.z);
  }

  private static TriangleMesh stalk() {
    Spine bent = Spine.of(0, 0.07, 0, 0, 0.105, 0, 0.012, 0.125, 0, 0.032, 0.138, 0);
    return Sweep.tube(bent, 6, t -> 0.022 - 0.01 * t);
  }
}
