package org.selectiverenderer.bench.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.walkthrough.budget.ObjectPlaces;

/**
 * Each rule keeps the budget and spends it as it says; two objects, near and small, far and big.
 */
class VersionRuleTest {
  @TempDir private Path folder;
  private ControlledWorld live;

  private static String object(String name, String place, double size) {
    return "<Transform translation='%s'><Switch DEF='%s' whichChoice='0'>".formatted(place, name)
        + "<Group>"
        + "<Shape><Box size='%1$s %1$s %1$s'/></Shape>".formatted(size).repeat(100)
        + "</Group><Shape><Box size='%1$s %1$s %1$s'/></Shape>".formatted(size)
        + "<MetadataSet containerField='metadata'>"
        + "<MetadataSet><MetadataString name='schemaBelonginess' value='\"A\"'/></MetadataSet>"
        + "<MetadataSet><MetadataString name='degreeOfConsistency' value='\"high\"'/>"
        + "<MetadataString name='schemaBelonginess' value='\"B\"'/></MetadataSet>"
        + "</MetadataSet></Switch></Transform>";
  }

  @BeforeEach
  void open() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Full'><Scene>"
                + object("Near", "0 0 -3", 0.2)
                + object("Far", "0 0 -8", 4)
                + "</Scene></X3D>");
    Path path = Files.writeString(folder.resolve("path.csv"), "t,x,y,z\n0,0,0,0\n1,0,0,0\n");
    live =
        new ControlledWorld(
            scene,
            CameraPathReader.read(path, new ProblemCollector()).orElseThrow(),
            Settings.SELECTIVE.within(RenderingBudget.of("triangles:1").orElseThrow()));
    live.step(0);
  }

  @AfterEach
  void close() {
    live.close();
  }

  @ParameterizedTest
  @EnumSource
  void everyRuleKeepsTheBudget(VersionRule rule) {
    ObjectPlaces places = live.places();
    assertThat(rule.choose(places, live.world.viewer(), 2400)).containsExactly(0, 0);
    assertThat(rule.choose(places, live.world.viewer(), 24)).containsExactly(1, 1);
    assertThat(rule.choose(places, live.world.viewer(), 0)).containsExactly(1, 1);
    int[] chosen = rule.choose(places, live.world.viewer(), 1300);
    assertThat(VersionRule.cost(places, chosen)).isEqualTo(1212);
  }

  @Test
  void distancePrefersTheNearOneAndTheOthersTheOneThatIsSeenLarger() {
    ObjectPlaces places = live.places();
    assertThat(VersionRule.DISTANCE.choose(places, live.world.viewer(), 1300))
        .containsExactly(0, 1);
    assertThat(VersionRule.SCREEN_ERROR.choose(places, live.world.viewer(), 1300))
        .containsExactly(1, 0);
    assertThat(VersionRule.LEAST_LOSS.choose(places, live.world.viewer(), 1300))
        .containsExactly(1, 0);
  }

  @Test
  void whatIsChosenIsShown() {
    live.show(new int[] {1, 0});
    assertThat(live.choices()).containsExactly(1, 0);
    assertThat(live.world.shownPolygons()).isEqualTo(1212);
  }
}
