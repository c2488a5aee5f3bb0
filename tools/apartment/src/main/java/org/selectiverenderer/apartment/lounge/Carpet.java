package org.selectiverenderer.apartment.lounge;

import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.TextureMapping;

/**
 * A carpet, 2.6 m by 1.8 m without its fringes, with borders, lozenges and pile: a texture of a
 * quarter of it, mirrored.
 */
final class Carpet {
  private static final double THICK = 0.009;
  private static final double WIDTH = 2.6;
  private static final double DEPTH = 1.8;
  private static final ModelMaterial WOVEN =
      ModelMaterial.matt(ModelColour.grey(1))
          .clad(TextureMapping.quarter(TextureRegistry.CARPET, WIDTH / 2, DEPTH / 2));

  private Carpet() {}

  static ParametricModel model() {
    // Two fields by two: the texture is mirrored at the edges between them.
    TriangleMesh top = ParametricSurface.field(WIDTH, DEPTH, 2, 2, (x, z) -> THICK);
    return ParametricModel.of(
        "carpet",
        Part.of("pile", WOVEN, ParametricSurface.thicken(top, 0, -THICK, 0)),
        Part.of("fringes", Materials.CREAM_CLOTH, MeshPatterns.bothSides(fringe())));
  }

  /** Returns the fringe at the right end, each tuft a flat triangle. */
  private static TriangleMesh fringe() {
    float[] corners = {1.3f, 0.004f, 0.028f, 1.36f, 0.001f, 0.004f, 1.3f, 0.004f, -0.028f};
    TriangleMesh tuft = new TriangleMesh(corners, new int[] {0, 1, 2});
    return MeshPatterns.row(tuft.move(0, 0, -0.87), 30, 0, 0, 0.06);
  }
}
