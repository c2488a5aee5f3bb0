package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import org.joml.Matrix4d;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;

class AreaHandleDragTest {
  private static final int WIDTH = 800;
  private static final int HEIGHT = 600;

  @TempDir Path folder;

  private AreaInstance area(String nodes) throws IOException {
    EnricherSession session = TestSessions.with(folder, nodes);
    return AreaLocator.of(session.enrichment()).get(0);
  }

  /** From the front, the right and above. */
  private static Camera camera(double x, double y, double z) {
    return new Camera(
        new Matrix4d().lookAt(x, y, z, 0, 0, 0, 0, 1, 0),
        new Matrix4d().setPerspective(0.8, WIDTH / (double) HEIGHT, 0.1, 100),
        0,
        0,
        WIDTH,
        HEIGHT);
  }

  private static Vector2d pixel(Vector3dc place, Camera camera) {
    return AreaHandleDrag.inPicture(place, camera).orElseThrow();
  }

  /** Drags a handle to where a place of the scene is seen. */
  private static AreaBox dragged(
      AreaInstance area, int handle, Vector3d to, Camera camera, double step) {
    Vector2d from = pixel(AreaHandleDrag.place(area, handle), camera);
    Vector2d now = pixel(to, camera);
    return new AreaHandleDrag(area, handle, camera, from.x, from.y)
        .at(now.x, now.y, new SnapGrid(step));
  }

  private static void near(Vector3dc is, double x, double y, double z) {
    assertThat(is.distance(x, y, z)).as("%s", is).isCloseTo(0, within(1e-4));
  }

  @Test
  void aFaceFollowsThePointerAlongItsDirectionAndTheOppositeOneStays() throws IOException {
    AreaInstance area = area("<ProximitySensor DEF='A' size='2 2 2'/>\n");
    Camera camera = camera(5, 4, 8);
    AreaBox wider = dragged(area, 1, new Vector3d(2.23, 0, 0), camera, 0);
    near(wider.size(), 3.23, 2, 2);
    near(wider.centre(), 0.615, 0, 0);
    near(dragged(area, 1, new Vector3d(2.23, 0, 0), camera, 0.1).size(), 3.2, 2, 2);
    AreaBox lower = dragged(area, 2, new Vector3d(0, -1.5, 0), camera, 0);
    near(lower.size(), 2, 2.5, 2);
    near(lower.centre(), 0, -0.25, 0);
    AreaBox least = dragged(area, 5, new Vector3d(0, 0, -3), camera, 0);
    near(least.size(), 2, 2, 0.05);
    near(least.centre(), 0, 0, -0.975);
  }

  @Test
  void theMiddleMovesOverTheGroundFromAboveAndUpAndDownFromTheSide() throws IOException {
    AreaInstance area = area("<ProximitySensor DEF='A' size='2 2 2'/>\n");
    AreaBox over =
        dragged(area, AreaHandleDrag.MIDDLE, new Vector3d(1.02, 0, 0.47), camera(3, 6, 6), 0.5);
    near(over.centre(), 1, 0, 0.5);
    AreaBox up =
        dragged(area, AreaHandleDrag.MIDDLE, new Vector3d(0, 0.6, 0), camera(0, 0.1, 8), 0);
    near(up.centre(), 0, 0.6, 0);
  }

  @Test
  void aTurnedAreaGrowsAlongItsOwnSide() throws IOException {
    AreaInstance area =
        area(
            "<Transform rotation='0 1 0 0.5' scale='2 2 2'>"
                + "<ProximitySensor DEF='A' size='1 1 1'/></Transform>\n");
    Vector3d side = area.frame().direction(0);
    AreaBox wider = dragged(area, 1, new Vector3d(side).mul(1.5), camera(5, 4, 8), 0);
    near(wider.size(), 2.5, 2, 2);
    near(wider.centre(), side.x * 0.25, 0, side.z * 0.25);
  }
}
