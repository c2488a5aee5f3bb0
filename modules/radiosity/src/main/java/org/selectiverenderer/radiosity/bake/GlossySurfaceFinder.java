package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Finds glossy surfaces, and how many texels a textured one needs. A Material adds specular
 * highlights to one emitted texture, {@code emissiveTexture}; X3D has no product of two textures
 * there (4.0, 12.4.5). So the surface's own texture must be merged into the lightmap, which then
 * needs the texture's resolution.
 */
public final class GlossySurfaceFinder {
  /** Least brightest channel of the specular colour of a glossy surface. */
  private static final float BRIGHT = 0.3f;

  /** Least shininess of a glossy surface: an exponent of 26, a highlight of some 20 degrees. */
  private static final float SMALL = 0.2f;

  /** Factor of the texels for those beside a chart's border that are not on the chart. */
  private static final double ROOM = 1.1;

  private GlossySurfaceFinder() {}

  /**
   * Returns whether a surface is glossy: its specular colour is bright and its highlights are small
   * enough to be seen as such. A wide, weak highlight can hardly be told from the diffuse light
   * beneath it.
   */
  public static boolean shines(SurfaceMaterial surface) {
    float[] specular = surface.specular();
    float most = Math.max(specular[0], Math.max(specular[1], specular[2]));
    return surface.lit() && most >= BRIGHT && surface.shininess() >= SMALL;
  }

  /**
   * Returns by body the number of texels from which on its own texture can be merged into its
   * lightmap; 0 for bodies that are not glossy or have no such texture.
   */
  public static double[] texels(RadiosityScene scene) {
    double[] texels = new double[scene.bodies().size()];
    for (int i = 0; i < texels.length; i++) {
      Body body = scene.bodies().get(i);
      if (shines(body.shape().surface()) && DiffuseTexture.on(body)) {
        DiffuseTexture image = DiffuseTexture.of(body);
        boolean part = image.node().isPresent() && !image.hasAlpha();
        texels[i] = part ? ROOM * image.pixels() / TextureBakePlan.FEW : 0;
      }
    }
    return texels;
  }
}
