package org.selectiverenderer.radiosity;

import java.util.List;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.bake.OwnTexture;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;

/** What authors hear about the images on their surfaces before the long work. */
final class TextureNotes {
  private TextureNotes() {}

  /** Where light is stored at vertices. */
  static void atVertices(LightScene scene, Problems problems) {
    List<Body> textured =
        scene.bodies().stream().filter(body -> body.shape().surface().texture() != null).toList();
    if (!textured.isEmpty()) {
      problems.info(
          textured.get(0).shape().node().location(),
          "textures are averaged over each triangle, and the lit scene has none (%s)"
              .formatted(shapes(textured.size())));
    }
  }

  /** Where it is stored in pictures. */
  static void inPictures(LightScene scene, Problems problems) {
    List<Body> flat =
        scene.bodies().stream()
            .filter(body -> OwnTexture.on(body) && OwnTexture.of(body).flat())
            .toList();
    if (!flat.isEmpty()) {
      problems.info(
          flat.get(0).shape().node().location(),
          "the texture coordinates lie in one line or point, so the texture is drawn as stripes or"
              + " one colour, with light and without (%s)".formatted(shapes(flat.size())));
    }
  }

  private static String shapes(int count) {
    return count == 1 ? "1 shape" : count + " shapes";
  }
}
