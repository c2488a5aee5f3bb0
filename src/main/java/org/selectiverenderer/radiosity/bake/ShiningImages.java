package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.runtime.instance.Surface;

/**
 * Surfaces that shine and have an image. A Material adds highlights to one picture that it sends
 * out, {@code emissiveTexture}; X3D has no product of two there (4.0, 12.4.5). So the image must be
 * part of the picture of the light, which has to be as fine for that.
 */
public final class ShiningImages {
  /** Of the brightest part of the specular colour. */
  private static final float BRIGHT = 0.3f;

  /** Of shininess: an exponent of 26, a highlight of some 20 degrees. */
  private static final float SMALL = 0.2f;

  /** Not every texel beside a chart's border is on it. */
  private static final double ROOM = 1.1;

  private ShiningImages() {}

  /**
   * Whether a surface shines: whether its specular colour is bright and its highlights are small
   * enough to be seen as such. A wide, weak one is hardly told from the diffuse light beneath it.
   */
  public static boolean shines(Surface surface) {
    float[] specular = surface.specular();
    float most = Math.max(specular[0], Math.max(specular[1], specular[2]));
    return surface.lit() && most >= BRIGHT && surface.shininess() >= SMALL;
  }

  /** Texels by body, from which on its image can be part of its picture; 0 for others. */
  public static double[] texels(LightScene scene) {
    double[] texels = new double[scene.bodies().size()];
    for (int i = 0; i < texels.length; i++) {
      Body body = scene.bodies().get(i);
      if (shines(body.shape().surface()) && OwnTexture.on(body)) {
        OwnTexture image = OwnTexture.of(body);
        boolean part = image.node().isPresent() && !image.hasAlpha();
        texels[i] = part ? ROOM * image.pixels() / TextureUse.FEW : 0;
      }
    }
    return texels;
  }
}
