package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** A painted chair with a ladder back and an oak seat at 0.46 m; its back is at -z. */
final class KitchenChair {

  private KitchenChair() {}

  static ParametricModel model() {
    TriangleMesh frontLeg = RoundSolidBuilder.cone(0.014, 0.02, 0.44, 8).move(0.18, 0, 0.17);
    TriangleMesh side = Sweep.tube(Spine.of(0.18, 0.2, 0.17, 0.18, 0.2, -0.185), 0.009, 6);
    return ModelPlacement.centred(
        "kitchenChair",
        Part.of("seat", Materials.LIGHT_OAK, seat()),
        Part.of(
            "frame",
            ModelMaterial.satin(ModelColour.hex(0xDDD8CC)),
            MeshPatterns.bothSides(TriangleMesh.of(frontLeg, backPost(), side)),
            Sweep.tube(Spine.of(-0.18, 0.26, 0.17, 0.18, 0.26, 0.17), 0.009, 6),
            slat(0.58, -0.205),
            slat(0.7, -0.225),
            slat(0.82, -0.25)));
  }

  private static TriangleMesh seat() {
    SimplePolygon seenFromAbove =
        SimplePolygon.of(-0.2, -0.2, 0.2, -0.2, 0.18, 0.2, -0.18, 0.2).rounded(0.04, 2);
    return RoundedSlabs.lying(seenFromAbove, 0.028, 0.01, 2).move(0, 0.434, 0);
  }

  /** Returns a post from the floor to the top of the leaning back. */
  private static TriangleMesh backPost() {
    Spine line =
        Spine.of(
            0.17, 0, -0.21, 0.175, 0.25, -0.185, 0.175, 0.45, -0.185, 0.175, 0.7, -0.225, 0.175,
            0.9, -0.27);
    return Sweep.tube(line, 8, t -> 0.013 + 0.024 * t * (1 - t));
  }

  /** Returns a slat between the posts, curved for the sitter's back. */
  private static TriangleMesh slat(double y, double z) {
    Spine curve =
        Spine.of(
            -0.175, y, z, -0.09, y, z - 0.022, 0, y, z - 0.029, 0.09, y, z - 0.022, 0.175, y, z);
    return Sweep.of(SimplePolygon.rectangle(0.014, 0.065), curve);
  }
}
