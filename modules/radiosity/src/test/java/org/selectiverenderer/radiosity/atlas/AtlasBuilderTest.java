package org.selectiverenderer.radiosity.atlas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.OptionalDouble;
import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

class AtlasBuilderTest {
  private static final String PLANE =
      TestScenes.quad("0 0 0, 0 0 2, 2 0 2, 2 0 0", "diffuseColor='1 1 1'");

  private static Atlas checked(String shapes) throws Exception {
    RadiosityScene scene = TestScenes.read(X3dShapeFixtures.lit(shapes));
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasInvariants.check(scene, atlas);
    return atlas;
  }

  private static Atlas make(RadiosityScene scene, AtlasSettings settings)
      throws RadiosityException {
    return new AtlasBuilder(settings, new ProblemCollector())
        .make(scene, new int[scene.bodies().size()]);
  }

  @Test
  void aSquareIsOneChartAndFillsItsTexels() throws Exception {
    Atlas atlas = checked(PLANE);
    assertThat(AtlasInvariants.charts(atlas)).isEqualTo(1);
    AtlasPage map = atlas.pages().get(0);
    // 40 texels a metre of what is 4 m large, 2 to the power of 0.4 as many for half of that.
    long used = java.util.stream.IntStream.of(map.chart()).filter(c -> c >= 0).count();
    assertThat(used).isEqualTo(106L * 106);
    assertThat(map.width()).isEqualTo(112);
    assertThat(map.height()).isEqualTo(112);
  }

  @Test
  void aBoxHasSixCharts() throws Exception {
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.shape("<Box size='2 1 0.5'/>"))))
        .isEqualTo(6);
  }

  @Test
  void theTwoSidesOfAThinPlateAreApart() throws Exception {
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.shape("<Box size='1 0.001 1'/>"))))
        .isEqualTo(6);
  }

  @Test
  void roundBodiesFallIntoFewCharts() throws Exception {
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.shape("<Sphere radius='0.5'/>"))))
        .isLessThanOrEqualTo(10);
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.shape("<Cylinder/>"))))
        .isLessThanOrEqualTo(8);
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.shape("<Cone/>"))))
        .isLessThanOrEqualTo(8);
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.torus()))).isLessThanOrEqualTo(20);
  }

  @ParameterizedTest
  @ValueSource(strings = {"<Sphere radius='0.3'/>", "<Cone/>", "<Box size='2 1 0.5'/>"})
  void trianglesStretchByTwoAtMostAndNoneIsTurnedOver(String geometry) throws Exception {
    RadiosityScene scene = TestScenes.read(X3dShapeFixtures.lit(X3dShapeFixtures.shape(geometry)));
    double[] range = AtlasInvariants.stretch(scene, make(scene, AtlasSettings.DEFAULT));
    assertThat(range[0]).isGreaterThan(0.48);
    assertThat(range[1]).isLessThan(1.3);
  }

  @Test
  void aStripWithOneSideIsCutOpen() throws Exception {
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.moebius()))).isBetween(2L, 16L);
  }

  @Test
  void aRampThatWindsUpDoesNotLieOnItself() throws Exception {
    assertThat(AtlasInvariants.charts(checked(X3dShapeFixtures.ramp()))).isBetween(3L, 40L);
  }

  @Test
  void aSurfaceDrawnTwiceHasTexelsForBoth() throws Exception {
    String points = "0 0 0, 1 0 0, 1 1 0, 0 1 0";
    Atlas atlas = checked(X3dShapeFixtures.triangles(points, "0 1 2 0 2 3 0 1 2 0 2 3"));
    assertThat(AtlasInvariants.charts(atlas)).isBetween(2L, 4L);
  }

  @Test
  void edgesWithVerticesInBetweenPartCharts() throws Exception {
    String points = "0 0 0, 1 0 0, 2 0 0, 0 1 0, 2 1 0, 0 -1 0, 1 -1 0, 2 -1 0";
    Atlas atlas =
        checked(X3dShapeFixtures.triangles(points, "0 2 4 0 4 3 5 6 1 5 1 0 6 7 2 6 2 1"));
    assertThat(AtlasInvariants.charts(atlas)).isEqualTo(2);
  }

  @Test
  void trianglesWithoutAreaHaveATexel() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(
                X3dShapeFixtures.triangles(
                    "0 0 0, 1 0 0, 2 0 0, 0 1 0, 1 1 1", "0 1 2 0 1 3 0 0 1 3 4 3")));
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasInvariants.check(scene, atlas);
    for (float st : atlas.layouts().get(0).st()) {
      assertThat(st).isBetween(0f, 1f);
    }
  }

  @Test
  void mirroredBodiesAreAsGoodAsOthers() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(
                "<Transform scale='-1 1 1'>"
                    + X3dShapeFixtures.shape("<Sphere/>")
                    + "</Transform>"));
    assertThat(scene.bodies().get(0).mirrored()).isTrue();
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasInvariants.check(scene, atlas);
    assertThat(AtlasInvariants.charts(atlas)).isLessThanOrEqualTo(10);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void anySoupOfTrianglesKeepsTheLaws(long seed) throws Exception {
    checked(X3dShapeFixtures.soup(seed));
  }

  @Test
  void smallBodiesAreStoredFiner() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(
                TestScenes.quad("0 0 0, 0 0 4, 4 0 4, 4 0 0", "")
                    + X3dShapeFixtures.shape("<Box size='0.1 0.1 0.1'/>")));
    double[] densities = TexelDensity.of(scene, AtlasSettings.DEFAULT);
    assertThat(densities[0]).isEqualTo(40);
    assertThat(densities[1]).isEqualTo(120);
  }

  @Test
  void bodiesOfOneGroupShareAPage() throws Exception {
    RadiosityScene scene = TestScenes.read(X3dShapeFixtures.lit(PLANE + PLANE + PLANE));
    Atlas atlas =
        new AtlasBuilder(AtlasSettings.DEFAULT, new ProblemCollector())
            .make(scene, new int[] {4, -1, 4});
    AtlasInvariants.check(scene, atlas);
    assertThat(atlas.pages()).hasSize(1);
    assertThat(atlas.layouts().get(0).page()).isZero();
    assertThat(atlas.layouts().get(1).page()).isEqualTo(AtlasPage.NONE);
    assertThat(atlas.layouts().get(2).page()).isZero();
  }

  @Test
  void theBudgetIsKept() throws Exception {
    RadiosityScene scene = TestScenes.read(X3dShapeFixtures.lit(PLANE + X3dShapeFixtures.torus()));
    Atlas atlas = make(scene, new AtlasSettings(OptionalDouble.empty(), 30_000, 2048));
    assertThat(atlas.texels()).isBetween(7_000L, 10_000L);
  }

  @Test
  void aBudgetThatCannotBeKeptIsToldBeforehand() throws Exception {
    RadiosityScene scene =
        TestScenes.read(X3dShapeFixtures.lit(X3dShapeFixtures.soup(1) + X3dShapeFixtures.torus()));
    assertThatThrownBy(() -> make(scene, new AtlasSettings(OptionalDouble.empty(), 1024, 2048)))
        .isInstanceOf(RadiosityException.class)
        .hasMessageMatching(
            "light in textures takes 0\\.\\d+ MB even at the least density, more than the budget"
                + " of 0\\.001 MB; raise --texture-budget");
    assertThatThrownBy(() -> make(scene, new AtlasSettings(OptionalDouble.of(500), 1 << 20, 2048)))
        .isInstanceOf(RadiosityException.class)
        .hasMessageMatching(
            "light in textures takes [\\d.]+ MB at 500 texels per metre, more than the budget of"
                + " 1\\.0 MB; lower --texels-per-metre or raise --texture-budget");
  }

  @Test
  void aHugeSurfaceIsBoundedByItsPageAndSaysSo() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(TestScenes.quad("0 0 0, 0 0 2000, 2000 0 2000, 2000 0 0", "")));
    ProblemCollector problems = new ProblemCollector();
    Atlas atlas =
        new AtlasBuilder(new AtlasSettings(OptionalDouble.of(100), 100 << 20, 256), problems)
            .make(scene, new int[1]);
    assertThat(atlas.pages().get(0).width()).isLessThanOrEqualTo(256);
    Problem told = problems.list().get(0);
    assertThat(told.severity()).isEqualTo(Problem.Severity.INFO);
    assertThat(told.message())
        .isEqualTo(
            "the shape is too large for its light to be stored finer than 0.125 texels per metre");
    assertThat(told.location().toString()).startsWith("test.x3d:1:");
  }

  @Test
  @Timeout(60)
  void aSlabBothOfWhoseSidesAreMoreThanHalfOfAPageIsBounded() throws Exception {
    Atlas atlas = checked(X3dShapeFixtures.shape("<Box size='26 0.2 26'/>"));
    assertThat(atlas.pages()).hasSize(1);
  }

  @Test
  @Timeout(60)
  void aShapeInMorePiecesThanAPageHoldsIsTold() throws Exception {
    StringBuilder points = new StringBuilder();
    StringBuilder indices = new StringBuilder();
    for (int i = 0; i < 600; i++) {
      points.append("0 0 %d, 1 0 %d, 0 1 %d, ".formatted(i, i, i));
      indices.append("%d %d %d ".formatted(3 * i, 3 * i + 1, 3 * i + 2));
    }
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(
                X3dShapeFixtures.triangles(points.toString(), indices.toString())));
    AtlasSettings small = new AtlasSettings(OptionalDouble.empty(), 24 << 20, 64);
    assertThatThrownBy(() -> make(scene, small))
        .isInstanceOf(RadiosityException.class)
        .hasMessageMatching(
            "test.x3d:1:\\d+: the shape is cut into 600 charts, more than one lightmap page holds;"
                + " divide it into several shapes, or use --store vertices");
  }

  @Test
  void anyNumberOfProcessorsMakesTheSame() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            X3dShapeFixtures.lit(
                PLANE
                    + X3dShapeFixtures.torus()
                    + X3dShapeFixtures.soup(3)
                    + X3dShapeFixtures.moebius()));
    Atlas one = make(scene, AtlasSettings.DEFAULT);
    ForkJoinPool alone = new ForkJoinPool(1);
    try {
      Atlas other = alone.submit(() -> make(scene, AtlasSettings.DEFAULT)).get();
      for (int i = 0; i < one.pages().size(); i++) {
        assertThat(other.pages().get(i).triangle()).isEqualTo(one.pages().get(i).triangle());
        assertThat(other.pages().get(i).u()).isEqualTo(one.pages().get(i).u());
        assertThat(other.pages().get(i).chart()).isEqualTo(one.pages().get(i).chart());
      }
      for (int i = 0; i < one.layouts().size(); i++) {
        assertThat(other.layouts().get(i).st()).isEqualTo(one.layouts().get(i).st());
      }
    } finally {
      alone.shutdown();
    }
  }
}
