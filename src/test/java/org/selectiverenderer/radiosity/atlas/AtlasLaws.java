package org.selectiverenderer.radiosity.atlas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;

/** What holds for every atlas. */
final class AtlasLaws {
  private AtlasLaws() {}

  static void check(LightScene scene, Atlas atlas) {
    atlas.pages().forEach(AtlasLaws::chartsKeepApart);
    for (int page = 0; page < atlas.pages().size(); page++) {
      placesLieInTheirTexels(scene, atlas, page);
    }
    for (int triangle = 0; triangle < scene.triangles().count(); triangle++) {
      if (atlas.layouts().get(scene.bodyOf()[triangle]).page() >= 0) {
        whatIsShownIsNear(scene, atlas, triangle);
      }
    }
  }

  static long charts(Atlas atlas) {
    return atlas.pages().stream()
        .mapToLong(map -> IntStream.of(map.chart()).filter(c -> c >= 0).distinct().count())
        .sum();
  }

  /** Two texels between charts, and around the border of a page, which repeats. */
  private static void chartsKeepApart(TexelMap map) {
    for (int y = 0; y < map.height(); y++) {
      for (int x = 0; x < map.width(); x++) {
        int chart = map.chart()[y * map.width() + x];
        for (int k = 0; k < 25 && chart >= 0; k++) {
          int nx = Math.floorMod(x + k % 5 - 2, map.width());
          int ny = Math.floorMod(y + k / 5 - 2, map.height());
          assertThat(map.chart()[ny * map.width() + nx])
              .as("beside texel %d %d", x, y)
              .isIn(chart, TexelMap.NONE);
        }
      }
    }
  }

  private static void placesLieInTheirTexels(LightScene scene, Atlas atlas, int page) {
    TexelMap map = atlas.pages().get(page);
    double[] xy = new double[2];
    for (int texel = 0; texel < map.texels(); texel++) {
      assertThat(map.triangle()[texel] >= 0).isEqualTo(map.chart()[texel] >= 0);
      if (map.chart()[texel] < 0) {
        continue;
      }
      float u = map.u()[texel];
      float v = map.v()[texel];
      assertThat(u).isBetween(0f, 1f);
      assertThat(v).isBetween(0f, 1.000001f - u);
      assertThat(atlas.layouts().get(scene.bodyOf()[map.triangle()[texel]]).page()).isEqualTo(page);
      texels(scene, atlas, map.triangle()[texel], u, v, xy);
      double dx = xy[0] - texel % map.width() - 0.5;
      double dy = xy[1] - texel / map.width() - 0.5;
      assertThat(Math.hypot(dx, dy)).isLessThan(0.72);
    }
  }

  /**
   * Places all over a triangle lie in texels of one chart, and these show places that are no
   * farther away than a texel is large.
   */
  private static void whatIsShownIsNear(LightScene scene, Atlas atlas, int triangle) {
    int body = scene.bodyOf()[triangle];
    TexelMap map = atlas.pages().get(atlas.layouts().get(body).page());
    double[] xy = new double[2];
    double[] place = new double[3];
    double[] shown = new double[3];
    Random random = new Random(triangle);
    double reach = 3.2 * texelSize(scene, atlas, triangle);
    int chart = TexelMap.NONE;
    for (int i = 0; i < 12; i++) {
      double u = i < 3 ? 0.01 + (i == 1 ? 0.98 : 0) : random.nextDouble();
      double v = i < 3 ? 0.005 + (i == 2 ? 0.98 : 0) : random.nextDouble() * (1 - u);
      texels(scene, atlas, triangle, u, v, xy);
      int texel = (int) xy[1] * map.width() + (int) xy[0];
      if (map.chart()[texel] < 0) {
        // It reaches into the texel by rounding only.
        assertThat(Math.min(fraction(xy[0]), fraction(xy[1]))).isLessThan(1e-3);
        continue;
      }
      chart = chart < 0 ? map.chart()[texel] : chart;
      assertThat(map.chart()[texel]).isEqualTo(chart);
      assertThat(scene.bodyOf()[map.triangle()[texel]]).isEqualTo(body);
      scene.triangles().point(triangle, u, v, place);
      scene.triangles().point(map.triangle()[texel], map.u()[texel], map.v()[texel], shown);
      double away =
          Math.hypot(Math.hypot(place[0] - shown[0], place[1] - shown[1]), place[2] - shown[2]);
      assertThat(away).as("at triangle %d", triangle).isLessThan(reach);
    }
  }

  private static double fraction(double x) {
    return Math.min(x - Math.floor(x), Math.ceil(x) - x);
  }

  /** The longest side of a texel on a body by the density of its chart's longest triangle. */
  private static double texelSize(LightScene scene, Atlas atlas, int triangle) {
    Body body = scene.body(triangle);
    double[] wished = Density.of(scene, AtlasSettings.DEFAULT);
    return 1 / wished[scene.bodies().indexOf(body)];
  }

  /** Where a place of a triangle lies on its page, texels. */
  static void texels(
      LightScene scene, Atlas atlas, int triangle, double u, double v, double[] out) {
    int body = scene.bodyOf()[triangle];
    Atlas.Layout layout = atlas.layouts().get(body);
    TexelMap map = atlas.pages().get(layout.page());
    int at = 6 * (triangle - scene.bodies().get(body).firstTriangle());
    float[] st = layout.st();
    double w = 1 - u - v;
    out[0] = (w * st[at] + u * st[at + 2] + v * st[at + 4]) * map.width();
    out[1] = (w * st[at + 1] + u * st[at + 3] + v * st[at + 5]) * map.height();
  }
}
