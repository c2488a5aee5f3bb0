package org.selectiverenderer.walkthrough.transition;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.control.SwitchVisibility;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * The pixels that showed an object as it changed, against those counted one by one. The viewer is
 * at the origin and looks along -Z; the picture has 1024 x 768 pixels.
 */
class SwitchPixelsTest {
  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;
  private static final double FOCAL = HEIGHT / 2.0 / Math.tan(Math.PI / 8);

  private static final String AREA =
      "<ProximitySensor DEF='Area' size='2 2 2'><MetadataSet containerField='metadata'>"
          + "<MetadataString name='enterTimeSchema' value='\"near\"'/>"
          + "<MetadataString name='exitTimeSchema' value='\"far\"'/></MetadataSet>"
          + "</ProximitySensor>";

  @TempDir Path folder;

  private static String version(String degree, String schema) {
    return "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
        + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>".formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "</MetadataSet>";
  }

  private static String shape(String geometry, double transparency) {
    return "<Shape><Appearance><Material transparency='%s'/></Appearance>%s</Shape>"
        .formatted(transparency, geometry);
  }

  /** An object of two equal versions that changes as the viewer comes. */
  private static String object(int shown, String placed, String shape) {
    return "<Transform %s><Switch DEF='Can' whichChoice='%d'>".formatted(placed, shown)
        + shape
        + shape
        + "<MetadataSet containerField='metadata'>"
        + version("low", "near")
        + version("high", "far")
        + "</MetadataSet></Switch></Transform>";
  }

  private static String sphere(double radius, String at) {
    return object(1, "translation='%s'".formatted(at), ball(radius, 0));
  }

  private static String ball(double radius, double transparency) {
    return shape("<Sphere radius='%s'/>".formatted(radius), transparency);
  }

  private SwitchVisibility seen(String nodes) throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(
        scene, "<X3D version='4.0' profile='Full'><Scene>" + nodes + AREA + "</Scene></X3D>");
    List<SwitchVisibility> seen = new ArrayList<>();
    try (Walkthrough walk =
        Walkthrough.open(
            scene,
            Settings.SELECTIVE,
            problem -> {},
            event -> {
              if (event instanceof TimelineEvent.ControllerEvent told
                  && told.event() instanceof SwitchChange change) {
                change.seen().ifPresent(seen::add);
              }
            },
            text -> {})) {
      walk.observeSwitches();
      for (int frame = 0; frame < 2; frame++) {
        double x = frame == 0 ? 500 : 0;
        walk.step(
            frame,
            (viewer, now, dt) -> {
              viewer.moveTo(new Vector3d(x, 0, 0));
              viewer.turnTo(Viewer.orientation(0, 0, 0));
            });
      }
    }
    assertThat(seen).hasSize(1);
    return seen.get(0);
  }

  /** Counts the pixels whose rays, with -1 as their z, hit. */
  private static long pixels(Predicate<Vector3d> hits) {
    long count = 0;
    Vector3d ray = new Vector3d();
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        ray.set((x + 0.5 - WIDTH / 2) / FOCAL, (y + 0.5 - HEIGHT / 2) / FOCAL, -1);
        count += hits.test(ray) ? 1 : 0;
      }
    }
    return count;
  }

  private static Predicate<Vector3d> ballAt(double radius, double x, double y, double z) {
    Vector3d middle = new Vector3d(x, y, z);
    return ray -> ray.cross(middle, new Vector3d()).length() / ray.length() < radius;
  }

  private void check(String nodes, Predicate<Vector3d> hits, double share) throws IOException {
    SwitchVisibility seen = seen(nodes);
    long truth = pixels(hits);
    assertThat(seen.visible()).isTrue();
    assertThat(seen.pixels()).as("of %d", truth).isCloseTo(truth, within(truth * share));
  }

  @Test
  void aSphereSomeMetresAway() throws IOException {
    check(sphere(0.5, "0 0 -5"), ballAt(0.5, 0, 0, -5), 0.12);
  }

  @Test
  void aSphereNearTheEye() throws IOException {
    check(sphere(0.5, "0 0 -1.5"), ballAt(0.5, 0, 0, -1.5), 0.12);
    check(sphere(0.5, "0.2 0.1 -0.8"), ballAt(0.5, 0.2, 0.1, -0.8), 0.12);
  }

  @Test
  void aSphereThatTheEdgeOfThePictureCuts() throws IOException {
    check(sphere(0.5, "1.1 0 -2"), ballAt(0.5, 1.1, 0, -2), 0.15);
    check(sphere(0.5, "-0.6 -0.5 -1"), ballAt(0.5, -0.6, -0.5, -1), 0.15);
  }

  @Test
  void aSphereOfWhichAWallHidesTheHalf() throws IOException {
    String wall =
        "<Transform translation='-2 0 -0.5'>" + shape("<Box size='4 4 0.01'/>", 0) + "</Transform>";
    Predicate<Vector3d> ball = ballAt(0.5, 0, 0, -1.5);
    check(sphere(0.5, "0 0 -1.5") + wall, ray -> ray.x > 0 && ball.test(ray), 0.15);
  }

  @Test
  void aSphereOfGlassIsSeenLikeAnother() throws IOException {
    String glass = object(1, "translation='0 0 -1.5'", ball(0.5, 0.7));
    check(glass, ballAt(0.5, 0, 0, -1.5), 0.12);
  }

  @Test
  void anObjectThatAppearsCountsByItsVersion() throws IOException {
    String none = object(-1, "translation='0 0 -1.5'", ball(0.5, 0));
    check(none, ballAt(0.5, 0, 0, -1.5), 0.12);
  }

  @Test
  void aSphereFarAway() throws IOException {
    check(sphere(0.05, "0 0 -20"), ballAt(0.05, 0, 0, -20), 0.4);
  }

  /** It reaches from 3 m behind the eye to 3 m before it, 0.8 m below. */
  @Test
  void aTableThatReachesBehindTheEye() throws IOException {
    String table = object(1, "translation='0 -0.825 0'", shape("<Box size='1 0.05 6'/>", 0));
    check(
        table,
        ray -> {
          double reach = ray.y < 0 ? 0.8 / -ray.y : Double.POSITIVE_INFINITY;
          return reach < 3 && Math.abs(ray.x * reach) < 0.5;
        },
        0.15);
  }

  @Test
  void aThinPoleAcrossThePicture() throws IOException {
    String pole =
        object(
            1,
            "translation='0 0 -5' rotation='0 0 1 0.7854'",
            shape("<Box size='0.02 3 0.02'/>", 0));
    Vector3d along = new Vector3d(-1, 1, 0).normalize();
    check(
        pole,
        ray -> {
          Vector3d at = new Vector3d(ray).mul(4.99);
          at.z = 0;
          double on = at.dot(along);
          return Math.abs(on) < 1.5 && at.fma(-on, along).length() < 0.01;
        },
        0.4);
  }
}
