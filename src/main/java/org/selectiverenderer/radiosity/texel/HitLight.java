package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * What a ray sees where it ends: light from the lamps as the texel there has it, so that shadows
 * are as sharp as they are seen, and light from surfaces as the patch has it. Immutable; for
 * several threads.
 */
final class HitLight {
  private final LightScene scene;
  private final Solution solution;
  private final Texels texels;
  private final float[] direct;

  /**
   * @param direct irradiance from the lamps by all texels
   */
  HitLight(LightScene scene, Solution solution, Texels texels, float[] direct) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.direct = direct;
  }

  /** Writes the radiance r, g, b of the place that a ray has met, cd/m2. */
  void of(Ray ray, double[] out) {
    int patch = solution.patches().at(ray.triangle, ray.u, ray.v, ray.behind);
    int body = scene.bodyOf()[ray.triangle];
    int texel = ray.behind ? -1 : texel(ray, body);
    if (texel < 0 || !texels.wanted(texel)) {
      for (int c = 0; c < 3; c++) {
        out[c] = solution.reflected()[3 * patch + c] + solution.glow()[3 * patch + c];
      }
      return;
    }
    Body of = scene.bodies().get(body);
    int rho = of.reflectanceAt(ray.triangle - of.firstTriangle());
    double opaque = 1.0 - of.transmittance(); // It was met, so it is not all transparent.
    for (int c = 0; c < 3; c++) {
      double irradiance = direct[3 * texel + c] + solution.indirect()[3 * patch + c];
      double share = of.reflectance()[rho + c] / opaque;
      out[c] = share * irradiance / Math.PI + solution.glow()[3 * patch + c];
    }
  }

  private int texel(Ray ray, int body) {
    Atlas.Layout layout = texels.atlas().layouts().get(body);
    if (layout.page() < 0) {
      return -1;
    }
    TexelMap map = texels.map(layout.page());
    int at = 6 * (ray.triangle - scene.bodies().get(body).firstTriangle());
    float[] st = layout.st();
    double w = 1 - ray.u - ray.v;
    double s = w * st[at] + ray.u * st[at + 2] + ray.v * st[at + 4];
    double t = w * st[at + 1] + ray.u * st[at + 3] + ray.v * st[at + 5];
    int x = (int) Math.floor(s * map.width());
    int y = (int) Math.floor(t * map.height());
    if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) {
      return -1;
    }
    return texels.first(layout.page()) + y * map.width() + x;
  }
}
