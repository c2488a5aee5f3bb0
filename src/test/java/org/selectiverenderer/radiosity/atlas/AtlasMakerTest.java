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
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.SmallScene;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;

class AtlasMakerTest {
  private static final String PLANE =
      SmallScene.quad("0 0 0, 0 0 2, 2 0 2, 2 0 0", "diffuseColor='1 1 1'");

  private static Atlas checked(String shapes) throws Exception {
    LightScene scene = SmallScene.read(Shapes.lit(shapes));
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasLaws.check(scene, atlas);
    return atlas;
  }

  private static Atlas make(LightScene scene, AtlasSettings settings) throws UnlitSceneException {
    return new AtlasMaker(settings, new Problems()).make(scene, new int[scene.bodies().size()]);
  }

  @Test
  void aSquareIsOneChartAndFillsItsTexels() throws Exception {
    Atlas atlas = checked(PLANE);
    assertThat(AtlasLaws.charts(atlas)).isEqualTo(1);
    TexelMap map = atlas.pages().get(0);
    // 40 texels a metre of what is 4 m large, 2 to the power of 0.4 as many for half of that.
    long used = java.util.stream.IntStream.of(map.chart()).filter(c -> c >= 0).count();
    assertThat(used).isEqualTo(106L * 106);
    assertThat(map.width()).isEqualTo(112);
    assertThat(map.height()).isEqualTo(112);
  }

  @Test
  void aBoxHasSixCharts() throws Exception {
    assertThat(AtlasLaws.charts(checked(Shapes.shape("<Box size='2 1 0.5'/>")))).isEqualTo(6);
  }

  @Test
  void theTwoSidesOfAThinPlateAreApart() throws Exception {
    assertThat(AtlasLaws.charts(checked(Shapes.shape("<Box size='1 0.001 1'/>")))).isEqualTo(6);
  }

  @Test
  void roundBodiesFallIntoFewCharts() throws Exception {
    assertThat(AtlasLaws.charts(checked(Shapes.shape("<Sphere radius='0.5'/>"))))
        .isLessThanOrEqualTo(10);
    assertThat(AtlasLaws.charts(checked(Shapes.shape("<Cylinder/>")))).isLessThanOrEqualTo(8);
    assertThat(AtlasLaws.charts(checked(Shapes.shape("<Cone/>")))).isLessThanOrEqualTo(8);
    assertThat(AtlasLaws.charts(checked(Shapes.torus()))).isLessThanOrEqualTo(20);
  }

  @ParameterizedTest
  @ValueSource(strings = {"<Sphere radius='0.3'/>", "<Cone/>", "<Box size='2 1 0.5'/>"})
  void trianglesStretchByTwoAtMostAndNoneIsTurnedOver(String geometry) throws Exception {
    LightScene scene = SmallScene.read(Shapes.lit(Shapes.shape(geometry)));
    double[] range = AtlasLaws.stretch(scene, make(scene, AtlasSettings.DEFAULT));
    assertThat(range[0]).isGreaterThan(0.48);
    assertThat(range[1]).isLessThan(1.3);
  }

  @Test
  void aStripWithOneSideIsCutOpen() throws Exception {
    assertThat(AtlasLaws.charts(checked(Shapes.moebius()))).isBetween(2L, 16L);
  }

  @Test
  void aRampThatWindsUpDoesNotLieOnItself() throws Exception {
    assertThat(AtlasLaws.charts(checked(Shapes.ramp()))).isBetween(3L, 40L);
  }

  @Test
  void aSurfaceDrawnTwiceHasTexelsForBoth() throws Exception {
    String points = "0 0 0, 1 0 0, 1 1 0, 0 1 0";
    Atlas atlas = checked(Shapes.triangles(points, "0 1 2 0 2 3 0 1 2 0 2 3"));
    assertThat(AtlasLaws.charts(atlas)).isBetween(2L, 4L);
  }

  @Test
  void edgesWithVerticesInBetweenPartCharts() throws Exception {
    String points = "0 0 0, 1 0 0, 2 0 0, 0 1 0, 2 1 0, 0 -1 0, 1 -1 0, 2 -1 0";
    Atlas atlas = checked(Shapes.triangles(points, "0 2 4 0 4 3 5 6 1 5 1 0 6 7 2 6 2 1"));
    assertThat(AtlasLaws.charts(atlas)).isEqualTo(2);
  }

  @Test
  void trianglesWithoutAreaHaveATexel() throws Exception {
    LightScene scene =
        SmallScene.read(
            Shapes.lit(
                Shapes.triangles("0 0 0, 1 0 0, 2 0 0, 0 1 0, 1 1 1", "0 1 2 0 1 3 0 0 1 3 4 3")));
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasLaws.check(scene, atlas);
    for (float st : atlas.layouts().get(0).st()) {
      assertThat(st).isBetween(0f, 1f);
    }
  }

  @Test
  void mirroredBodiesAreAsGoodAsOthers() throws Exception {
    LightScene scene =
        SmallScene.read(
            Shapes.lit("<Transform scale='-1 1 1'>" + Shapes.shape("<Sphere/>") + "</Transform>"));
    assertThat(scene.bodies().get(0).mirrored()).isTrue();
    Atlas atlas = make(scene, AtlasSettings.DEFAULT);
    AtlasLaws.check(scene, atlas);
    assertThat(AtlasLaws.charts(atlas)).isLessThanOrEqualTo(10);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void anySoupOfTrianglesKeepsTheLaws(long seed) throws Exception {
    checked(Shapes.soup(seed));
  }

  @Test
  void smallBodiesAreStoredFiner() throws Exception {
    LightScene scene =
        SmallScene.read(
            Shapes.lit(
                SmallScene.quad("0 0 0, 0 0 4, 4 0 4, 4 0 0", "")
                    + Shapes.shape("<Box size='0.1 0.1 0.1'/>")));
    double[] densities = Density.of(scene, AtlasSettings.DEFAULT);
    assertThat(densities[0]).isEqualTo(40);
    assertThat(densities[1]).isEqualTo(120);
  }

  @Test
  void bodiesOfOneGroupShareAPage() throws Exception {
    LightScene scene = SmallScene.read(Shapes.lit(PLANE + PLANE + PLANE));
    Atlas atlas =
        new AtlasMaker(AtlasSettings.DEFAULT, new Problems()).make(scene, new int[] {4, -1, 4});
    AtlasLaws.check(scene, atlas);
    assertThat(atlas.pages()).hasSize(1);
    assertThat(atlas.layouts().get(0).page()).isZero();
    assertThat(atlas.layouts().get(1).page()).isEqualTo(TexelMap.NONE);
    assertThat(atlas.layouts().get(2).page()).isZero();
  }

  @Test
  void theBudgetIsKept() throws Exception {
    LightScene scene = SmallScene.read(Shapes.lit(PLANE + Shapes.torus()));
    Atlas atlas = make(scene, new AtlasSettings(OptionalDouble.empty(), 30_000, 2048));
    assertThat(atlas.texels()).isBetween(7_000L, 10_000L);
  }

  @Test
  void aBudgetThatCannotBeKeptIsToldBeforehand() throws Exception {
    LightScene scene = SmallScene.read(Shapes.lit(Shapes.soup(1) + Shapes.torus()));
    assertThatThrownBy(() -> make(scene, new AtlasSettings(OptionalDouble.empty(), 1024, 2048)))
        .isInstanceOf(UnlitSceneException.class)
        .hasMessageMatching(
            "light in textures takes 0\\.\\d+ MB even at the least density, more than the budget"
                + " of 0\\.001 MB; raise --texture-budget");
    assertThatThrownBy(() -> make(scene, new AtlasSettings(OptionalDouble.of(500), 1 << 20, 2048)))
        .isInstanceOf(UnlitSceneException.class)
        .hasMessageMatching(
            "light in textures takes [\\d.]+ MB at 500 texels per metre, more than the budget of"
                + " 1\\.0 MB; lower --texels-per-metre or raise --texture-budget");
  }

  @Test
  void aHugeSurfaceIsBoundedByItsPageAndSaysSo() throws Exception {
    LightScene scene =
        SmallScene.read(Shapes.lit(SmallScene.quad("0 0 0, 0 0 2000, 2000 0 2000, 2000 0 0", "")));
    Problems problems = new Problems();
    Atlas atlas =
        new AtlasMaker(new AtlasSettings(OptionalDouble.of(100), 100 << 20, 256), problems)
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
    Atlas atlas = checked(Shapes.shape("<Box size='26 0.2 26'/>"));
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
    LightScene scene =
        SmallScene.read(Shapes.lit(Shapes.triangles(points.toString(), indices.toString())));
    AtlasSettings small = new AtlasSettings(OptionalDouble.empty(), 24 << 20, 64);
    assertThatThrownBy(() -> make(scene, small))
        .isInstanceOf(UnlitSceneException.class)
        .hasMessageMatching(
            "test.x3d:1:\\d+: the shape is cut into 600 charts, more than one lightmap page holds;"
                + " divide it into several shapes, or use --store vertices");
  }

  @Test
  void anyNumberOfProcessorsMakesTheSame() throws Exception {
    LightScene scene =
        SmallScene.read(Shapes.lit(PLANE + Shapes.torus() + Shapes.soup(3) + Shapes.moebius()));
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
