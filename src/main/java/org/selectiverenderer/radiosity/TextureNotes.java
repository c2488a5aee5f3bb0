package org.selectiverenderer.radiosity;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.bake.OwnTexture;
import org.selectiverenderer.radiosity.bake.ShiningImages;
import org.selectiverenderer.radiosity.bake.TextureUse;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.runtime.instance.SurfaceDetail;
import org.selectiverenderer.runtime.scene.Node;

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
    left(scene, problems);
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

  /** What shines and does so no more, when it is known which images stay apart. */
  static void withoutHighlights(LightScene scene, TextureUse use, Problems problems) {
    List<Body> matt = new ArrayList<>();
    for (int i = 0; i < scene.bodies().size(); i++) {
      Body body = scene.bodies().get(i);
      if (use.apart(i) && ShiningImages.shines(body.shape().surface())) {
        matt.add(body);
      }
    }
    if (!matt.isEmpty()) {
      problems.info(
          matt.get(0).shape().node().location(),
          ("the surface loses its highlights, since its image is much finer than its light, repeats"
                  + " often or has holes, and stays apart; raise --texels-per-metre or"
                  + " --texture-budget, or give it an image with fewer pixels (%s)")
              .formatted(shapes(matt.size())));
    }
  }

  /** Images beyond the first, of which none is in the lit scene. */
  private static void left(LightScene scene, Problems problems) {
    List<Body> several = scene.bodies().stream().filter(body -> images(body) > 1).toList();
    if (several.isEmpty()) {
      return;
    }
    Body first = several.get(0);
    Node appearance = Objects.requireNonNull(first.shape().node().node("appearance"));
    Node texture = Objects.requireNonNull(appearance.node("texture"));
    problems.warning(
        texture.location(),
        ("the lit scene has the first of the %s images of this MultiTexture only; make one image of"
                + " them to keep what the others show (%s)")
            .formatted(images(first), shapes(several.size())));
  }

  /** The images of a MultiTexture; 0 for another texture. */
  private static int images(Body body) {
    SurfaceDetail detail = body.shape().surface().detail();
    return detail == null ? 0 : detail.stages().size();
  }

  private static String shapes(int count) {
    return count == 1 ? "1 shape" : count + " shapes";
  }
}
