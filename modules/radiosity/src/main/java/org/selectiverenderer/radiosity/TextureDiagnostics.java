package org.selectiverenderer.radiosity;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.radiosity.bake.DiffuseTexture;
import org.selectiverenderer.radiosity.bake.GlossySurfaceFinder;
import org.selectiverenderer.radiosity.bake.TextureBakePlan;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** Tells authors what becomes of the textures on their surfaces, before the long computation. */
final class TextureDiagnostics {
  private TextureDiagnostics() {}

  /** Reports textures that a scene lit at its vertices loses. */
  static void atVertices(RadiosityScene scene, ProblemCollector problems) {
    List<Body> textured =
        scene.bodies().stream().filter(body -> body.shape().surface().texture() != null).toList();
    if (!textured.isEmpty()) {
      problems.info(
          textured.get(0).shape().node().location(),
          "--store vertices averages textures over each triangle and drops their images (%s)"
              .formatted(shapes(textured.size())));
    }
  }

  /** Reports textures that a scene lit by lightmaps keeps in part only. */
  static void inPictures(RadiosityScene scene, ProblemCollector problems) {
    left(scene, problems);
    List<Body> flat =
        scene.bodies().stream()
            .filter(body -> DiffuseTexture.on(body) && DiffuseTexture.of(body).flat())
            .toList();
    if (!flat.isEmpty()) {
      problems.info(
          flat.get(0).shape().node().location(),
          "all texture coordinates lie on one line or point, so the texture is drawn as stripes or"
              + " one colour, with light and without (%s)".formatted(shapes(flat.size())));
    }
  }

  /**
   * Reports glossy surfaces that lose their highlights because their image stays a texture of its
   * own.
   */
  static void withoutHighlights(
      RadiosityScene scene, TextureBakePlan use, ProblemCollector problems) {
    List<Body> matt = new ArrayList<>();
    for (int i = 0; i < scene.bodies().size(); i++) {
      Body body = scene.bodies().get(i);
      if (use.apart(i) && GlossySurfaceFinder.shines(body.shape().surface())) {
        matt.add(body);
      }
    }
    if (!matt.isEmpty()) {
      problems.info(
          matt.get(0).shape().node().location(),
          ("the surface loses its highlights, since its texture is much finer than the lightmap,"
                  + " repeats often or has transparency and cannot be merged with it; raise"
                  + " --texels-per-metre or --texture-budget, or use a smaller image (%s)")
              .formatted(shapes(matt.size())));
    }
  }

  /** Reports MultiTextures, of which the lit scene has the first image only. */
  private static void left(RadiosityScene scene, ProblemCollector problems) {
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

  /** Returns the number of images of a MultiTexture; 0 for another texture. */
  private static int images(Body body) {
    ExtendedMaterial detail = body.shape().surface().detail();
    return detail == null ? 0 : detail.stages().size();
  }

  private static String shapes(int count) {
    return count == 1 ? "1 shape" : count + " shapes";
  }
}
