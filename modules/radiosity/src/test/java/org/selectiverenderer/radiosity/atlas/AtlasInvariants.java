package org.selectiverenderer.radiosity.atlas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.util.Random;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** What holds for every atlas. */
final class AtlasInvariants {
  private AtlasInvariants() {}

  static void check(RadiosityScene scene, Atlas atlas) {
    atlas.pages().forEach(AtlasInvariants::chartsKeepApart);
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
  private static void chartsKeepApart(AtlasPage map) {
    for (int y = 0; y < map.height(); y++) {
      for (int x = 0; x < map.width(); x++) {
        int chart = map.chart()[y * map.width() + x];
        for (int k = 0; k < 25 && chart >= 0; k++) {
          int nx = Math.floorMod(x + k % 5 - 2, map.width());
          int ny = Math.floorMod(y + k / 5 - 2, map.height());
          int beside = map.chart()[ny * map.width() + nx];
          if (beside != chart && beside != AtlasPage.NONE) {
            fail("charts %d and %d touch at texel %d %d", chart, beside, x, y);
          }
        }
      }
    }
  }

  private static void placesLieInTheirTexels(RadiosityScene scene, Atlas atlas, int page) {
    AtlasPage map = atlas.pages().get(page);
    double[] xy = new double[2];
    for (int texel = 0; texel < map.texels(); texel++) {
      if (map.triangle()[texel] >= 0 != map.chart()[texel] >= 0) {
        fail("texel %d has a chart or a triangle, not both", texel);
      }
      if (map.chart()[texel] < 0) {
        continue;
      }
      float u = map.u()[texel];
      float v = map.v()[texel];
      int body = scene.bodyOf()[map.triangle()[texel]];
      texels(scene, atlas, map.triangle()[texel], u, v, xy);
      double dx = xy[0] - texel % map.width() - 0.5;
      double dy = xy[1] - texel / map.width() - 0.5;
      boolean near = dx * dx + dy * dy < 0.52 && u >= 0 && v >= 0 && u + v < 1.000001;
      if (!near || atlas.layouts().get(body).page() != page) {
        fail("texel %d shows %s %s of triangle %d", texel, u, v, map.triangle()[texel]);
      }
    }
  }

  /**
   * Places all over a triangle lie in texels of one chart, and these show places that are no
   * farther away than a texel is large.
   */
  private static void whatIsShownIsNear(RadiosityScene scene, Atlas atlas, int triangle) {
    int body = scene.bodyOf()[triangle];
    AtlasPage map = atlas.pages().get(atlas.layouts().get(body).page());
    double[] xy = new double[2];
    double[] place = new double[3];
    double[] shown = new double[3];
    Random random = new Random(triangle);
    double reach = 3.2 * texelSize(scene, atlas, triangle);
    int chart = AtlasPage.NONE;
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
  private static double texelSize(RadiosityScene scene, Atlas atlas, int triangle) {
    Body body = scene.body(triangle);
    double[] wished = TexelDensity.of(scene, AtlasSettings.DEFAULT);
    return 1 / wished[scene.bodies().indexOf(body)];
  }

  /**
   * The least and the largest area that a triangle has on its page, as a share of what its body's
   * density wishes, among charts of at least eight texels both ways: in smaller ones whole texels
   * stretch more than the chart does.
   */
  static double[] stretch(RadiosityScene scene, Atlas atlas) {
    double[] wished = TexelDensity.of(scene, AtlasSettings.DEFAULT);
    double[] range = {Double.POSITIVE_INFINITY, 0};
    double[] a = new double[2];
    double[] b = new double[2];
    double[] c = new double[2];
    double[] normal = new double[3];
    for (int triangle = 0; triangle < scene.triangles().count(); triangle++) {
      int body = scene.bodyOf()[triangle];
      AtlasPage map = atlas.pages().get(atlas.layouts().get(body).page());
      texels(scene, atlas, triangle, 1 / 3.0, 1 / 3.0, a);
      if (side(map, map.chart()[(int) a[1] * map.width() + (int) a[0]]) < 8) {
        continue;
      }
      texels(scene, atlas, triangle, 0, 0, a);
      texels(scene, atlas, triangle, 1, 0, b);
      texels(scene, atlas, triangle, 0, 1, c);
      double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      double area = scene.triangles().normal(triangle, normal) * wished[body] * wished[body];
      // A triangle that is turned over has an area below 0.
      range[0] = Math.min(range[0], twice / 2 / area);
      range[1] = Math.max(range[1], twice / 2 / area);
    }
    return range;
  }

  /** The shorter side of a chart, texels. */
  private static int side(AtlasPage map, int chart) {
    int[] texels = IntStream.range(0, map.texels()).filter(i -> map.chart()[i] == chart).toArray();
    var columns = IntStream.of(texels).map(i -> i % map.width()).summaryStatistics();
    var rows = IntStream.of(texels).map(i -> i / map.width()).summaryStatistics();
    return Math.min(columns.getMax() - columns.getMin(), rows.getMax() - rows.getMin()) + 1;
  }

  /** Where a place of a triangle lies on its page, texels. */
  static void texels(
      RadiosityScene scene, Atlas atlas, int triangle, double u, double v, double[] out) {
    int body = scene.bodyOf()[triangle];
    Atlas.Layout layout = atlas.layouts().get(body);
    AtlasPage map = atlas.pages().get(layout.page());
    int at = 6 * (triangle - scene.bodies().get(body).firstTriangle());
    float[] st = layout.st();
    double w = 1 - u - v;
    out[0] = (w * st[at] + u * st[at + 2] + v * st[at + 4]) * map.width();
    out[1] = (w * st[at + 1] + u * st[at + 3] + v * st[at + 5]) * map.height();
  }
}
