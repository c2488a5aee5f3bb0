package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Light at the point that a ray hits: direct light from the texel there, so that shadows are as
 * sharp as in the lightmap, and indirect light from the patch. Immutable; for several threads.
 */
final class HitRadiance {
  /** Squared length of a ray, in areas of the patch that it hits, below which the hit is near. */
  private static final double NEAR = 2.25;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final float[] direct;

  /**
   * @param direct irradiance r, g, b from the lamps at all texels, lx
   */
  HitRadiance(RadiosityScene scene, RadiositySolution solution, TexelIndex texels, float[] direct) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.direct = direct;
  }

  /** Returns the patch that a ray hit. */
  int patch(Ray ray) {
    return solution.patches().at(ray.triangle, ray.u, ray.v, ray.behind);
  }

  /**
   * Returns whether a ray's hit is so near that the patch there is too coarse, since the light of a
   * patch is a mean over its area.
   */
  boolean near(Ray ray, int patch) {
    return ray.length * ray.length < NEAR * solution.patches().area(patch);
  }

  /**
   * Writes the reflectance r, g, b at the point that a ray hit, per opaque share of the surface,
   * since that share stopped the ray.
   */
  void reflectance(Ray ray, double[] out) {
    Body body = scene.body(ray.triangle);
    int at = body.reflectanceAt(ray.triangle - body.firstTriangle());
    double opaque = 1.0 - body.transmittance();
    for (int c = 0; c < 3; c++) {
      out[c] = body.reflectance()[at + c] / opaque;
    }
  }

  /** Writes the direct irradiance r, g, b at the point that a ray hit, lx. */
  void direct(Ray ray, int patch, double[] out) {
    boolean shown = ray.behind == texels.sides().behind(ray.triangle);
    int texel = shown ? texel(ray, scene.bodyOf()[ray.triangle]) : -1;
    boolean known = texel >= 0 && texels.wanted(texel);
    for (int c = 0; c < 3; c++) {
      out[c] = known ? direct[3 * texel + c] : solution.direct()[3 * patch + c];
    }
  }

  /** Writes the indirect irradiance r, g, b on a patch, lx. */
  void indirect(int patch, double[] out) {
    for (int c = 0; c < 3; c++) {
      out[c] = solution.indirect()[3 * patch + c];
    }
  }

  /** Returns the emitted radiance of a patch in a colour channel, cd/m2. */
  double glow(int patch, int colour) {
    return solution.glow()[3 * patch + colour];
  }

  private int texel(Ray ray, int body) {
    Atlas.Layout layout = texels.atlas().layouts().get(body);
    if (layout.page() < 0) {
      return -1;
    }
    AtlasPage map = texels.map(layout.page());
    int own = ray.triangle - scene.bodies().get(body).firstTriangle();
    int x = (int) Math.floor(layout.s(own, ray.u, ray.v) * map.width());
    int y = (int) Math.floor(layout.t(own, ray.u, ray.v) * map.height());
    if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) {
      return -1;
    }
    return texels.first(layout.page()) + y * map.width() + x;
  }
}
