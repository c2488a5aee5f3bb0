package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.testing.ShowsWindows;

/** A model that is not dropped anywhere stands on the floor of what the preview shows. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class PlacementQueriesTest {
  private static final String ROOM =
      """
      <Transform translation='0 -0.05 0'><Shape><Box size='8 0.1 6'/></Shape></Transform>
      <Transform translation='0 1.4 -3'><Shape><Box size='8 2.8 0.1'/></Shape></Transform>
      <Transform translation='0 1.4 3'><Shape><Box size='8 2.8 0.1'/></Shape></Transform>
      <Transform translation='-4 1.4 0'><Shape><Box size='0.1 2.8 6'/></Shape></Transform>
      <Transform translation='4 1.4 0'><Shape><Box size='0.1 2.8 6'/></Shape></Transform>
      """;

  @TempDir Path folder;

  private Vector3d ahead(String scene) throws Exception {
    Path file =
        Files.writeString(
            folder.resolve("room.x3d"), "<X3D version='4.0'><Scene>" + scene + "</Scene></X3D>");
    try (PreviewWindowDriver window = new PreviewWindowDriver(file)) {
      window.awaitPicture();
      CompletableFuture<Optional<Vector3d>> answer = new CompletableFuture<>();
      EventThread.edt(() -> window.panel.placeAhead(answer::complete));
      return answer.get(60, TimeUnit.SECONDS).orElseThrow();
    }
  }

  @Test
  void theViewOfASceneWithoutViewpointPutsItOnTheFloorOfTheRoom() throws Exception {
    Vector3d at = ahead(ROOM);
    assertThat(at.y).as("%s", at).isCloseTo(0, within(1e-3));
    assertThat(at.x).isBetween(-3.9, 3.9);
    assertThat(at.z).isBetween(-2.9, 2.9);
  }

  @Test
  void aViewFromAbovePutsItOnTheSurfaceInTheMiddleOfThePicture() throws Exception {
    String table =
        "<Transform translation='2 0.7 1'><Shape><Box size='2 0.1 1'/></Shape></Transform>";
    Vector3d at = ahead("<Viewpoint position='2 9 1' orientation='1 0 0 -1.5708'/>" + ROOM + table);
    assertThat(at.distance(2, 0.75, 1)).as("%s", at).isLessThan(0.01);
  }

  @Test
  void aViewOfAWallFromOutsidePutsItIntoTheRoomBehindIt() throws Exception {
    Vector3d at = ahead("<Viewpoint position='1 1.6 12'/>" + ROOM);
    assertThat(at.distance(1, 0, 0)).as("%s", at).isLessThan(0.1);
  }

  @Test
  void aViewPastTheSceneStillPutsItIntoTheRoom() throws Exception {
    Vector3d at = ahead("<Viewpoint position='30 20 30'/>" + ROOM);
    assertThat(at.distance(0, 0, 0)).as("%s", at).isLessThan(0.1);
  }

  @Test
  void aViewerInTheRoomHasItTwoMetresAheadOnTheFloor() throws Exception {
    Vector3d at = ahead("<Viewpoint position='1 1.6 2'/>" + ROOM);
    assertThat(at.distance(1, 0, 0)).as("%s", at).isLessThan(0.01);
  }

  @Test
  void aSceneThatShowsNothingHasItOnItsGroundWhateverTheHeightOfTheEyes() throws Exception {
    for (String eyes : List.of("1.6", "0", "7")) {
      Vector3d at = ahead("<Viewpoint position='0 %s 10'/>".formatted(eyes));
      assertThat(at.distance(0, 0, 8)).as("%s from %s", at, eyes).isLessThan(0.01);
    }
  }

  /** A gallery without a floor of its own, beside a tower. */
  @Test
  void whereNothingIsBelowTheViewerItStandsAtTheFootOfTheScene() throws Exception {
    String towers =
        "<Transform translation='-5 6 0'><Shape><Box size='1 12 1'/></Shape></Transform>"
            + "<Transform translation='5 6 -6'><Shape><Box size='1 12 1'/></Shape></Transform>";
    Vector3d at = ahead("<Viewpoint position='0 7 0'/>" + towers);
    assertThat(at.distance(0, 0, -2)).as("%s", at).isLessThan(0.01);
  }
}
