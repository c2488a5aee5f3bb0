package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.viewer.Viewer;

class CameraTest {
  private static Viewer viewer() {
    Viewer viewer = new Viewer();
    viewer.moveTo(new Vector3d(1, 2, 3));
    viewer.turnTo(Viewer.orientation(Math.PI / 2, 0, 0));
    viewer.fieldOfView(Math.PI / 2);
    return viewer;
  }

  private static Vector3d clip(Camera camera, double x, double y, double z) {
    Vector3d eye = camera.view().transformPosition(x, y, z, new Vector3d());
    return camera.projection().transformProject(eye, new Vector3d());
  }

  @Test
  void theFieldOfViewIsTheSmallerAngle() {
    // Yaw 90 degrees looks along -X; a place 45 degrees up is at the upper edge of a wide picture.
    Camera wide = Camera.of(viewer(), 200, 100, 0.1, 100);
    assertThat(clip(wide, -1, 4, 3).y).isCloseTo(1, within(1e-12));
    assertThat(clip(wide, -1, 2, 1).x).isCloseTo(0.5, within(1e-12));
    Camera tall = Camera.of(viewer(), 100, 200, 0.1, 100);
    assertThat(clip(tall, -1, 4, 3).y).isCloseTo(0.5, within(1e-12));
    assertThat(clip(tall, -1, 2, 1).x).isCloseTo(1, within(1e-12));
  }

  @Test
  void theEyeIsWhereTheViewerIs() {
    Vector3d eye = new Vector3d(Camera.of(viewer(), 1, 1, 0.1, 100).eye());
    assertThat(eye.distance(1, 2, 3)).isLessThan(1e-12);
  }

  @Test
  void theDepthRangeEndsBehindTheFarthestThingShown() {
    TestScene scene =
        TestScene.of(
            "<Transform translation='0 0 -50'><Shape><Box/></Shape></Transform>"
                + "<Switch><Transform translation='0 0 -900'><Shape><Box/></Shape></Transform>"
                + "</Switch>");
    DepthRange range = DepthRange.of(scene.tree(), new Vector3d(), 0.25, 0);
    assertThat(range.near()).isEqualTo(0.125);
    assertThat(range.far()).isBetween(51.0, 53.0);
    assertThat(DepthRange.of(scene.tree(), new Vector3d(), 0.25, 20).far()).isEqualTo(20);
  }

  @Test
  void theNearPlaneOfALargeSceneDoesNotCutWhatIsNear() {
    String box = "<Transform translation='0 0 %s'><Shape><Box size='2 2 2'/></Shape></Transform>";
    TestScene alone = TestScene.of(box.formatted("-1e7"));
    assertThat(DepthRange.of(alone.tree(), new Vector3d(), 0.25, 0).near()).isBetween(100.0, 110.0);

    TestScene both = TestScene.of(box.formatted("-1e7") + box.formatted("-5"));
    assertThat(DepthRange.of(both.tree(), new Vector3d(), 0.25, 0).near()).isEqualTo(2);
    assertThat(DepthRange.of(both.tree(), new Vector3d(0, 0, -5), 0.25, 0).near()).isEqualTo(0.5);
    assertThat(DepthRange.of(both.tree(), new Vector3d(0, 0, -3.95), 0.25, 0).near())
        .isEqualTo(0.125);
  }

  @Test
  void theNearPlaneDoesNotCutASmallSceneThatIsToBeSeenWhole() {
    TestScene small = TestScene.of("<Shape><Box size='0.02 0.02 0.02'/></Shape>");
    Vector3d eye = new Vector3d(0, 0, 0.08);
    assertThat(DepthRange.of(small.tree(), eye, 0.25, 0).near()).isEqualTo(0.125);
    assertThat(DepthRange.of(small.tree(), eye, 0.25, 0, true).near()).isBetween(0.0009, 0.001);
    TestScene large = TestScene.of("<Shape><Box size='90 90 90'/></Shape>");
    assertThat(DepthRange.of(large.tree(), eye, 0.25, 0, true).near()).isEqualTo(0.125);
  }
}
