package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasBuilder;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.atlas.AtlasSettings;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

class VersionLightTransferTest {
  private static final String LIGHT = "<PointLight location='0 9 0'/>";
  private static final String DENSE = "<Sphere radius='0.5'/>";

  private static String shape(String geometry) {
    return "<Shape><Appearance><Material/></Appearance>" + geometry + "</Shape>";
  }

  private static String box(String size) {
    return shape("<Box size='" + size + "'/>");
  }

  private static String group(String... shapes) {
    return "<Group>" + String.join("", shapes) + "</Group>";
  }

  private static String choice(String... versions) {
    return "<Switch whichChoice='0'>" + String.join("", versions) + "</Switch>";
  }

  /** A body's texels after each of all others has the light that a place is given. */
  private static final class Lit {
    final RadiosityScene scene;
    final Atlas atlas;
    final VersionLightTransfer shared;
    final List<float[]> light = new ArrayList<>();

    Lit(String body, ToDoubleFunction<double[]> lux) throws Exception {
      scene = TestScenes.read(LIGHT + body);
      atlas =
          new AtlasBuilder(AtlasSettings.DEFAULT, new ProblemCollector())
              .make(scene, java.util.stream.IntStream.range(0, scene.bodies().size()).toArray());
      shared = VersionLightTransfer.find(scene, atlas, RadiosityProgress.NONE);
      double[] point = new double[3];
      for (int page = 0; page < atlas.pages().size(); page++) {
        AtlasPage map = atlas.pages().get(page);
        float[] rgb = new float[3 * map.texels()];
        for (int i = 0; i < map.texels(); i++) {
          if (map.triangle()[i] != AtlasPage.NONE && shared.wanted(page, i)) {
            place(map, i, point);
            java.util.Arrays.fill(rgb, 3 * i, 3 * i + 3, (float) lux.applyAsDouble(point));
          }
        }
        light.add(rgb);
      }
      shared.rest(light);
    }

    void place(AtlasPage map, int texel, double[] out) {
      scene.triangles().point(map.triangle()[texel], map.u()[texel], map.v()[texel], out);
    }

    /** The worst difference to what a texel's place should have, on a body's page. */
    double worst(int body, ToDoubleFunction<double[]> lux) {
      int page = atlas.layouts().get(body).page();
      AtlasPage map = atlas.pages().get(page);
      double[] point = new double[3];
      double worst = 0;
      for (int i = 0; i < map.texels(); i++) {
        if (map.triangle()[i] != AtlasPage.NONE) {
          place(map, i, point);
          worst = Math.max(worst, Math.abs(light.get(page)[3 * i] - lux.applyAsDouble(point)));
        }
      }
      return worst;
    }

    long wanted(int body) {
      int page = atlas.layouts().get(body).page();
      AtlasPage map = atlas.pages().get(page);
      return java.util.stream.IntStream.range(0, map.texels())
          .filter(i -> map.triangle()[i] != AtlasPage.NONE && shared.wanted(page, i))
          .count();
    }
  }

  /** Light that changes along all axes. */
  private static double ramp(double[] point) {
    return 100 + 10 * point[0] + 20 * point[1] + 30 * point[2];
  }

  @Test
  void aVersionTakesTheLightOfTheOneThatStandsForItsObject() throws Exception {
    String coarse =
        """
        <IndexedFaceSet creaseAngle='3' coordIndex='0 2 4 -1 2 1 4 -1 1 3 4 -1 3 0 4 -1
          2 0 5 -1 1 2 5 -1 3 1 5 -1 0 3 5 -1'>
        <Coordinate point='0.5 0 0, -0.5 0 0, 0 0.5 0, 0 -0.5 0, 0 0 0.5, 0 0 -0.5'/>
        </IndexedFaceSet>
        """;
    // An octahedron's faces lie 0.21 inside of the sphere: more than is near.
    Lit far = new Lit(choice(shape(coarse), shape(DENSE)), VersionLightTransferTest::ramp);
    assertThat(far.wanted(0)).isPositive();
    Lit lit =
        new Lit(choice(box("1 1 1"), group(box("1.01 1.01 1.01"), box("0.1 0.1 0.1"))), p -> 7);
    assertThat(lit.scene.versions().isReference(lit.scene.bodies().get(0).version())).isFalse();
    assertThat(lit.wanted(0)).isZero();
    assertThat(lit.wanted(1)).isPositive();
    assertThat(lit.worst(0, p -> 7)).isLessThan(1e-5);
  }

  @Test
  void lightThatChangesIsTakenFromTheNearestPlace() throws Exception {
    Lit lit =
        new Lit(
            choice(box("1 1 1"), group(box("1 1 1"), box("0.1 0.1 0.1"))),
            VersionLightTransferTest::ramp);
    // Both have the same texels; bilinear reading of a ramp is exact but at the borders.
    assertThat(lit.wanted(0)).isZero();
    assertThat(lit.worst(0, VersionLightTransferTest::ramp)).isLessThan(1e-3);
  }

  @Test
  void texelsOfAnotherSizeReadInBetween() throws Exception {
    // A plate of 12 triangles beside one of many: half a texel of the ramp at borders.
    String fine =
        "<Transform rotation='1 0 0 -1.5707963'>"
            + shape("<Rectangle2D size='1 1'/>")
            + shape("<Disk2D outerRadius='0.3'/>")
            + "</Transform>";
    String coarse =
        "<Transform translation='0 0.01 0' rotation='1 0 0 -1.5707963'>"
            + shape("<Rectangle2D size='0.8 0.8'/>")
            + "</Transform>";
    Lit lit = new Lit(choice(coarse, fine), VersionLightTransferTest::ramp);
    assertThat(lit.wanted(0)).isZero();
    assertThat(lit.worst(0, p -> ramp(p) - 0.2)).isLessThan(0.4);
  }

  @Test
  void theOtherSideOfAThinThingIsNotTaken() throws Exception {
    Lit lit =
        new Lit(
            choice(box("1 0.002 1"), group(box("1 0.002 1"), box("0.1 0.001 0.1"))),
            p -> p[1] > 0 ? 100 : 1);
    int page = lit.atlas.layouts().get(0).page();
    AtlasPage map = lit.atlas.pages().get(page);
    double[] normal = new double[3];
    for (int i = 0; i < map.texels(); i++) {
      if (map.triangle()[i] != AtlasPage.NONE) {
        lit.scene.triangles().normal(map.triangle()[i], normal);
        if (Math.abs(normal[1]) > 0.9) {
          assertThat(Math.round(lit.light.get(page)[3 * i])).isEqualTo(normal[1] > 0 ? 100 : 1);
        }
      }
    }
  }

  @Test
  void whatHasNoVersionsIsGathered() throws Exception {
    Lit lit = new Lit(box("1 1 1") + "<Switch whichChoice='-1'/>" + choice(box("1 1 1")), p -> 3);
    assertThat(lit.shared.count()).isZero();
    assertThat(lit.worst(0, p -> 3)).isZero();
    assertThat(lit.worst(1, p -> 3)).isZero();
  }

  @Test
  void versionsWithinAVersionShareWithTheObjectAroundThem() throws Exception {
    Lit lit =
        new Lit(
            choice(
                choice(box("1 1 1"), box("0.2 0.2 0.2")),
                group(
                    box("1 1 1"),
                    choice(box("1 1 1"), box("0.5 1 1")),
                    box("0.5 0.5 0.5"),
                    box("0.5 0.5 0.5"))),
            p -> 5);
    for (int body = 0; body < lit.scene.bodies().size(); body++) {
      assertThat(lit.worst(body, p -> 5)).isLessThan(1e-5);
    }
    assertThat(lit.shared.count()).isPositive();
  }

  @Test
  void anObjectThatIsNotShownIsGatheredByItself() throws Exception {
    Lit lit =
        new Lit(
            "<Switch whichChoice='-1'>" + box("1 1 1") + box("1 1 1") + "</Switch>" + box("1 1 1"),
            p -> 3);
    assertThat(lit.shared.count()).isZero();
    assertThat(lit.worst(0, p -> 3)).isZero();
  }
}
