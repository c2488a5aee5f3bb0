package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.MonteCarloFormFactors;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.solve.RadiositySolver;
import org.selectiverenderer.radiosity.solve.SurfacePatches;

/** A small scene with light at its texels. */
record TexelSceneFixture(RadiosityScene scene, IrradianceAtlas pages) {

  /**
   * @param density texels per metre
   * @param patch length of patches, metres
   */
  static TexelSceneFixture of(String body, double density, double patch) throws Exception {
    return of(body, density, patch, RadiosityProgress.NONE);
  }

  static TexelSceneFixture of(String body, double density, double patch, RadiosityProgress progress)
      throws Exception {
    RadiosityScene scene = TestScenes.read(body);
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(
            scene, new SurfacePatches(scene, patch), 64, 8, 1, RadiosityProgress.NONE);
    RadiositySolution solution =
        new RadiositySolver(scene, transport).solve(40, 99.9, RadiosityProgress.NONE, each -> {});
    Atlas atlas = QuadAtlas.of(scene, density);
    return new TexelSceneFixture(
        scene,
        new TexelGatherer(scene, solution, atlas, TexelGatherer.Effort.of(256, 0.03, true, 1))
            .gather(TexelSelection.ALL, progress));
  }

  /** Looks at a texel. */
  interface Look {
    /**
     * @param point x, y, z
     * @param lux of green
     */
    void at(double[] point, double lux);
  }

  /** Shows the texels of a body's charts. */
  void each(int body, Look look) {
    int page = pages.atlas().layouts().get(body).page();
    AtlasPage map = pages.atlas().pages().get(page);
    double[] point = new double[3];
    for (int i = 0; i < map.texels(); i++) {
      if (map.triangle()[i] != AtlasPage.NONE) {
        scene.triangles().point(map.triangle()[i], map.u()[i], map.v()[i], point);
        look.at(point, pages.irradiance().get(page)[3 * i + 1]);
      }
    }
  }

  /** The light of a body's texel nearest to a point. */
  double at(int body, double x, double y, double z) {
    double[] best = {Double.POSITIVE_INFINITY, 0};
    each(
        body,
        (point, lux) -> {
          double away =
              (point[0] - x) * (point[0] - x)
                  + (point[1] - y) * (point[1] - y)
                  + (point[2] - z) * (point[2] - z);
          if (away < best[0]) {
            best[0] = away;
            best[1] = lux;
          }
        });
    return best[1];
  }

  List<float[]> irradiance() {
    return pages.irradiance();
  }
}
