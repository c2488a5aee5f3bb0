package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Plans of scenes that run without a picture. */
class FloorPlanTest {
  /** A floor, a wall at X = -3 and one at Z = -2, up to 2.5 m, and a table. */
  private static final String ROOM =
      """
      <Transform translation='0 -0.05 0'><Shape><Box size='6 0.1 4'/></Shape></Transform>
      <Transform translation='-3 1.25 0'><Shape><Box size='0.1 2.5 4'/></Shape></Transform>
      <Transform translation='0 1.25 -2'><Shape><Box size='6 2.5 0.1'/></Shape></Transform>
      <Transform translation='1 0.4 1'><Shape DEF='Table'><Box size='1 0.8 1'/></Shape></Transform>
      """;

  private static final String CEILING =
      "<Transform translation='0 2.55 0'><Shape><Box size='6 0.1 4'/></Shape></Transform>";

  @TempDir Path folder;

  private void with(String nodes, Consumer<PreviewScene> work) throws Exception {
    String text = "<X3D profile='Immersive' version='4.0'><Scene>" + nodes + "</Scene></X3D>";
    SceneDocument document = SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
    try (PreviewScene scene =
        new PreviewScene(
            LoadedPreview.of(document.snapshot(), folder, ContentAccessPolicy.none()))) {
      work.accept(scene);
    }
  }

  private static FloorPlanImage plan(PreviewScene scene) {
    return FloorPlanRenderer.of(scene, OptionalDouble.empty(), Set.of()).orElseThrow();
  }

  @Test
  void aRoomWithoutAViewpointIsCutBetweenFloorAndCeilingSoThatItsWallsAreSeen() throws Exception {
    for (String nodes : new String[] {ROOM, ROOM + CEILING}) {
      with(
          nodes,
          scene -> {
            FloorPlanImage plan = plan(scene);
            assertThat(plan.cut()).isBetween(0.9, 1.6);
            assertThat(plan.walls()).as("two walls").hasSizeGreaterThanOrEqualTo(32);
          });
    }
  }

  @Test
  void theEyeOfAViewpointInTheRoomSaysWhereItIsCutOneAboveItDoesNot() throws Exception {
    with(
        ROOM + CEILING + "<Viewpoint position='0 1.7 0'/>",
        scene -> assertThat(plan(scene).cut()).isCloseTo(1.7, within(1e-6)));
    with(
        ROOM + CEILING + "<Viewpoint position='0 30 0' orientation='1 0 0 -1.57'/>",
        scene -> assertThat(plan(scene).cut()).isBetween(0.9, 1.6));
  }

  @Test
  void theLowestOfSeveralStoreysIsShown() throws Exception {
    with(
        ROOM
            + CEILING
            + "<Transform translation='0 2.6 0'><Group>"
            + ROOM.replace(" DEF='Table'", "")
            + CEILING
            + "</Group></Transform>",
        scene -> assertThat(plan(scene).cut()).isBetween(0.5, 2.0));
  }

  @Test
  void skyDomesAndEndlessGroundsNeitherFillThePlanNorMakeItSmall() throws Exception {
    with(
        "<Shape><Sphere radius='900'/></Shape><Shape><Sphere radius='1000' solid='false'/></Shape>"
            + "<Transform translation='0 -0.2 0'><Shape><Box size='2000 0.1 2000'/></Shape>"
            + "</Transform>"
            + ROOM,
        scene -> {
          FloorPlanImage plan = plan(scene);
          assertThat(plan.cut()).isBetween(0.9, 1.6);
          assertThat(plan.extent().width()).isLessThan(8);
          assertThat(plan.walls().length / 4).as("no line of the domes").isLessThan(40);
        });
  }

  @Test
  void aRoomOfOneMeshIsNoSkyDome() throws Exception {
    with(
        "<Shape><Box size='30 3 30' solid='false'/></Shape>"
            + "<Shape><Box size='0.2 0.2 0.2'/></Shape>",
        scene -> assertThat(plan(scene).extent().width()).isCloseTo(30, within(0.1)));
  }
}
