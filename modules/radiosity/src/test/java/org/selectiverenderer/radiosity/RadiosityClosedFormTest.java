package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.EnergyBalance;
import org.selectiverenderer.radiosity.solve.MonteCarloFormFactors;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.solve.RadiositySolver;
import org.selectiverenderer.radiosity.solve.SurfacePatches;

/** The solution on patches against closed forms and conservation. */
class RadiosityClosedFormTest {
  private static final String LAMP = "<PointLight location='0 5 0'/>";
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'"; // Reflects a half.
  private static final String BRIGHT = "diffuseColor='0.9 0.9 0.9'";
  private static final double HALF = Photometry.linear(0.735);

  private static double formFactor(String one, String other) throws Exception {
    RadiosityScene scene = TestScenes.read(LAMP + one + other);
    SurfacePatches patches = new SurfacePatches(scene, 100);
    assertThat(patches.count()).isEqualTo(2);
    return MonteCarloFormFactors.find(scene, patches, 16384, 1, 1, RadiosityProgress.NONE)
        .formFactor(0, 1);
  }

  private static RadiositySolution solve(
      RadiosityScene scene, double length, int iterations, List<RadiositySolution> all) {
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(
            scene, new SurfacePatches(scene, length), 256, 64, 1, RadiosityProgress.NONE);
    return new RadiositySolver(scene, transport)
        .solve(iterations, 100, RadiosityProgress.NONE, all::add);
  }

  /** Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11: 0.19982. */
  @Test
  void formFactorOfParallelSquaresIsThatOfTheCatalogue() throws Exception {
    double factor =
        formFactor(
            quad("1 1 1, 2 1 1, 2 2 1, 1 2 1", GREY), quad("1 1 2, 1 2 2, 2 2 2, 2 1 2", GREY));
    assertThat(factor).isCloseTo(0.19982, within(0.002));
  }

  /** The same, C-14: two squares that share an edge, 0.20004. */
  @Test
  void formFactorOfSquaresAtRightAnglesIsThatOfTheCatalogue() throws Exception {
    double factor =
        formFactor(
            quad("1 1 1, 2 1 1, 2 2 1, 1 2 1", GREY), quad("1 1 1, 1 1 2, 2 1 2, 2 1 1", GREY));
    assertThat(factor).isCloseTo(0.20004, within(0.002));
  }

  @Test
  void inAFurnaceEverySurfaceHasTheSameLight() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 2, GREY + " emissiveColor='0.735 0.735 0.735'"));
    RadiositySolution solution = solve(scene, 0.5, 60, new ArrayList<>());
    double emitted = HALF * Photometry.WHITE;
    double expected = emitted / (1 - HALF);
    for (int patch = 0; patch < solution.patches().count(); patch++) {
      assertThat((float) (emitted + solution.reflected()[3 * patch]))
          .isCloseTo((float) expected, within((float) (0.01 * expected)));
    }
  }

  @Test
  void noLightIsLostInAClosedRoom() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, GREY) + "<PointLight location='2 3 1'/>");
    List<RadiositySolution> all = new ArrayList<>();
    RadiositySolution solution = solve(scene, 0.4, 40, all);
    for (RadiositySolution each : all) {
      EnergyBalance balance = each.last();
      assertThat(balance.discrepancy()).isCloseTo(0, within(0.02));
      assertThat(balance.escaped()).isZero();
    }
    EnergyBalance last = solution.last();
    assertThat(last.emitted()).isCloseTo(scene.lumens(), within(0.02 * scene.lumens()));
    assertThat(last.absorbed()).isCloseTo(last.emitted(), within(0.02 * last.emitted()));
    assertThat(last.distributed()).isGreaterThan(99.9);
  }

  @Test
  void lightOnlyGrowsFromIterationToIteration() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            room(0, 0, 0, 4, GREY)
                + "<PointLight location='2 3 1'/>"
                + "<Transform translation='2 1 2'><Shape><Appearance><Material "
                + GREY
                + "/></Appearance><Box/></Shape></Transform>");
    List<RadiositySolution> all = new ArrayList<>();
    solve(scene, 0.4, 12, all);
    assertThat(all).hasSizeGreaterThan(5);
    double unshot = Double.POSITIVE_INFINITY;
    double distributed = 0;
    for (int k = 1; k < all.size(); k++) {
      for (int i = 0; i < all.get(k).reflected().length; i++) {
        assertThat(all.get(k).reflected()[i]).isGreaterThanOrEqualTo(all.get(k - 1).reflected()[i]);
      }
      assertThat(all.get(k).last().unshot()).isLessThan(unshot);
      assertThat(all.get(k).last().distributed()).isGreaterThanOrEqualTo(distributed);
      unshot = all.get(k).last().unshot();
      distributed = all.get(k).last().distributed();
    }
  }

  @Test
  void aSymmetricRoomIsLitSymmetrically() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, GREY) + "<PointLight location='2 2 2'/>");
    RadiositySolution solution = solve(scene, 100, 30, new ArrayList<>());
    // One patch to a wall: all six see the lamp and each other alike.
    assertThat(solution.patches().count()).isEqualTo(6);
    for (int patch = 1; patch < 6; patch++) {
      assertThat(solution.reflected()[3 * patch])
          .isCloseTo(solution.reflected()[0], within(0.01f * solution.reflected()[0]));
    }
  }

  @Test
  void noLightComesThroughAWall() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            room(0, 0, 0, 2, GREY) + room(2, 0, 0, 2, GREY) + "<PointLight location='1 1 1'/>");
    RadiositySolution solution = solve(scene, 0.3, 20, new ArrayList<>());
    int dark = 0;
    for (int patch = 0; patch < solution.patches().count(); patch++) {
      boolean lit = scene.bodyOf()[solution.patches().triangle(patch)] == 0;
      if (lit) {
        assertThat(solution.reflected()[3 * patch]).isPositive();
      } else {
        assertThat(solution.reflected()[3 * patch]).isZero();
        dark++;
      }
    }
    assertThat(dark).isGreaterThan(100);
  }

  @Test
  void aPaneLetsThroughItsShare() throws Exception {
    String floor = quad("-1 0 1, 1 0 1, 1 0 -1, -1 0 -1", GREY);
    String lamp = "<DirectionalLight direction='0 -1 0'/>";
    String pane =
        quad("-5 1 5, 5 1 5, 5 1 -5, -5 1 -5", "diffuseColor='0 0 0' transparency='0.75'");
    RadiosityScene open = TestScenes.read(floor + lamp);
    RadiosityScene covered = TestScenes.read(floor + pane + lamp);
    float free =
        MonteCarloFormFactors.find(
                open, new SurfacePatches(open, 100), 4, 4, 1, RadiosityProgress.NONE)
            .direct()[0];
    float less =
        MonteCarloFormFactors.find(
                covered, new SurfacePatches(covered, 100), 4, 4, 1, RadiosityProgress.NONE)
            .direct()[0];
    assertThat(less).isCloseTo(0.75f * free, within(1e-3f * free));
  }

  /** Half a pane throws back half of what a wall does: its share counts once. */
  @Test
  void aPaneThrowsBackItsShare() throws Exception {
    String floor = quad("-1 0 1, 1 0 1, 1 0 -1, -1 0 -1", "diffuseColor='0 0 0'");
    String over = "-1 1 -1, 1 1 -1, 1 1 1, -1 1 1";
    String lamp = "<PointLight location='0 0.5 0'/>";
    double wall = fromAbove(floor + quad(over, GREY) + lamp);
    double pane = fromAbove(floor + quad(over, GREY + " transparency='0.5'") + lamp);
    assertThat(pane).isCloseTo(wall / 2, within(0.05 * wall));
  }

  /** A floor of which a cupboard covers two thirds throws back light from the rest. */
  @Test
  void whatIsMostlyCoveredStillThrowsBackLight() throws Exception {
    String cupboard =
        "<Transform translation='2 1 1.35'><Shape><Appearance><Material "
            + GREY
            + "/></Appearance><Box size='3.96 2.02 2.66'/></Shape></Transform>";
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, GREY) + cupboard + "<PointLight location='2 3 3'/>");
    RadiositySolution solution = solve(scene, 100, 3, new ArrayList<>());
    int floor = solution.patches().at(10, 0.3, 0.3, false);
    assertThat(solution.buried()[floor]).isFalse();
    assertThat(solution.reflected()[3 * floor]).isPositive();
  }

  private static double fromAbove(String body) throws Exception {
    RadiosityScene scene = TestScenes.read(body);
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(
            scene, new SurfacePatches(scene, 100), 4096, 64, 1, RadiosityProgress.NONE);
    RadiositySolution solution =
        new RadiositySolver(scene, transport).solve(4, 100, RadiosityProgress.NONE, each -> {});
    return solution.indirect()[0];
  }

  /** Ending early costs no light: what is still to come is estimated and added. */
  @Test
  void whatIsStillToComeIsAddedWhenTheWantedQualityIsReached() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, BRIGHT) + "<PointLight location='2 3 1'/>");
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(
            scene, new SurfacePatches(scene, 0.5), 256, 16, 1, RadiosityProgress.NONE);
    RadiositySolution early =
        new RadiositySolver(scene, transport).solve(50, 90, RadiosityProgress.NONE, each -> {});
    RadiositySolution late =
        new RadiositySolver(scene, transport)
            .solve(200, 99.999, RadiosityProgress.NONE, each -> {});
    assertThat(early.balances()).hasSizeLessThan(late.balances().size() / 2);
    double off = 0;
    double sum = 0;
    for (int patch = 0; patch < early.patches().count(); patch++) {
      off += Math.abs(early.reflected()[3 * patch] - late.reflected()[3 * patch]);
      sum += late.reflected()[3 * patch];
    }
    assertThat(off).isLessThan(0.01 * sum);
  }

  /** A user who asks for one iteration gets light that was reflected once. */
  @Test
  void nothingIsAddedToANumberOfIterations() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, BRIGHT) + "<PointLight location='2 3 1'/>");
    List<RadiositySolution> all = new ArrayList<>();
    RadiositySolution last = solve(scene, 1, 4, all);
    assertThat(last.reflected()).isEqualTo(all.get(3).reflected());
  }

  /** Two centimetres before a square of a metre: Howell's catalogue, B-3, four quarters. */
  @Test
  void aPatchCloseToALargeLampHasTheLightOfAllOfIt() throws Exception {
    String lamp =
        "<SpotLight location='1 1 1' direction='0 -1 0'>"
            + "<MetadataSet containerField='metadata' name='photometric'>"
            + "<MetadataFloat containerField='value' name='size' value='1 1'/>"
            + "<MetadataFloat containerField='value' name='luminance' value='1000'/>"
            + "</MetadataSet></SpotLight>";
    String small = quad("0.9 %1$s 1.1, 1.1 %1$s 1.1, 1.1 %1$s 0.9, 0.9 %1$s 0.9", GREY);
    for (double down : new double[] {0.02, 0.3}) {
      double a = 0.5 / down;
      double edge = a / Math.sqrt(1 + a * a);
      double expected = 1000 * 4 * edge * Math.atan(edge);
      String below = small.formatted(String.valueOf(1 - down));
      RadiosityScene scene = TestScenes.read(below + lamp);
      SurfacePatches patches = new SurfacePatches(scene, 100);
      double lux =
          MonteCarloFormFactors.find(scene, patches, 64, 64, 1, RadiosityProgress.NONE).direct()[0];
      assertThat(lux).isCloseTo(expected, within(0.02 * expected));
    }
  }

  /** What a board covers closely must not darken what is seen beside it. */
  @Test
  void aFloorHalfUnderABoardThrowsBackWhatItsOpenHalfDoes() throws Exception {
    String floor = quad("1 0 3, 3 0 3, 3 0 1, 1 0 1", GREY);
    String board =
        "<Transform translation='2.5 0.06 2'><Shape><Appearance><Material "
            + "diffuseColor='0 0 0'/></Appearance><Box size='1 0.02 2'/></Shape></Transform>";
    String sun = "<DirectionalLight direction='0 -1 0'/>";
    double open = solve(TestScenes.read(floor + sun), 100, 3, new ArrayList<>()).reflected()[0];
    double half =
        solve(TestScenes.read(floor + board + sun), 100, 3, new ArrayList<>()).reflected()[0];
    assertThat(half).isCloseTo(open, within(0.1 * open));
  }

  /** Under a board that covers all there is less light, and what there is counts. */
  @Test
  void aFloorAllUnderABoardThrowsBackTheLightThatComesUnderIt() throws Exception {
    String floor = quad("1 0 3, 3 0 3, 3 0 1, 1 0 1", GREY);
    String board =
        "<Transform translation='2 0.11 2'><Shape><Appearance><Material "
            + GREY
            + "/></Appearance><Box size='2 0.02 2'/></Shape></Transform>";
    String lamp = "<PointLight location='3.5 0.05 2'/>";
    RadiositySolution solution =
        solve(TestScenes.read(floor + board + lamp), 100, 3, new ArrayList<>());
    assertThat(solution.buried()[0]).isFalse();
    assertThat(solution.reflected()[0]).isPositive();
  }

  @Test
  void photometricMetadataThatSaysNothingIsTold() throws Exception {
    String set =
        "<MetadataSet containerField='metadata' name='photometric'>"
            + "<MetadataFloat containerField='value' name='%s' value='%s'/></MetadataSet>";
    for (String said : List.of("lumens 800", "lux 800", "lumen -1")) {
      String[] words = said.split(" ");
      ProblemCollector problems = new ProblemCollector();
      TestScenes.read(
          room(0, 0, 0, 4, "diffuseColor='0.7 0.7 0.7'")
              + "<PointLight location='2 3 2'>"
              + set.formatted(words[0], words[1])
              + "</PointLight>",
          problems);
      assertThat(problems.list()).extracting(Problem::message).as(said).hasSize(1);
      assertThat(problems.list().get(0).message())
          .contains(words[0].equals("lumen") ? "lumen must be a number above 0" : "no member ")
          .contains("lumen");
    }
  }
}
