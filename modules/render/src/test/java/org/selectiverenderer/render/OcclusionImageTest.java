package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.joml.Matrix4d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.draw.VisibleSet;
import org.selectiverenderer.testing.RequiresDisplay;

/** Leaving out what is hidden changes no pixel. */
@RequiresDisplay
class OcclusionImageTest {
  /** Large enough that a mistake of one coarse cell, of 128 by 96, shows. */
  private static final int WIDTH = 480;

  private static final int HEIGHT = 360;

  /** Longer than it rests after it has found little. */
  private static final int LOOKS = 12;

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();
  private final Random random = new Random(11);

  @Test
  void inTheApartment() {
    TestScene scene = TestScene.load(Path.of("scenes/apartment.x3d"));
    scene.tree().update();
    assertThat(share(scene, 50, 0, 8.7, 1.2, 3.3)).isLessThan(0.6);
    assertThat(share(scene, 10, 4, 8.7, 1.2, 3.3)).isLessThan(0.6);
  }

  @Test
  void amongWallsWithSlitsAndHoles() {
    for (int trial = 0; trial < 3; trial++) {
      TestScene scene = TestScene.of(walls());
      assertThat(share(scene, 60, trial == 2 ? 4 : 0, 9, 3, 9)).isLessThan(0.6);
    }
  }

  /** Compares pictures from random poses; returns which share of the triangles was drawn. */
  private double share(TestScene scene, int poses, int samples, double x, double y, double z) {
    GL3 gl = studio.gl();
    OffscreenFramebuffer target = new OffscreenFramebuffer(gl, WIDTH, HEIGHT, samples);
    studio.renderer.prepare(gl, scene.tree());
    double all = 0;
    double drawn = 0;
    for (int pose = 0; pose < poses; pose++) {
      Camera camera = camera(x, y, z);
      List<Camera> eyes = List.of(camera);
      VisibleSet whole = studio.renderer.cullToView(studio.gl(), eyes);
      long indices = whole.indices();
      byte[] expected = draw(target, whole, camera);
      VisibleSet part = studio.renderer.cull(studio.gl(), eyes);
      for (int look = 1; look < LOOKS && part.indices() == indices; look++) {
        part = studio.renderer.cull(studio.gl(), eyes);
      }
      all += indices;
      drawn += part.indices();
      assertThat(draw(target, part, camera)).as("pose %d", pose).isEqualTo(expected);
    }
    target.dispose(gl);
    return drawn / all;
  }

  private byte[] draw(OffscreenFramebuffer target, VisibleSet seen, Camera camera) {
    target.bind(studio.gl());
    studio.renderer.draw(studio.gl(), seen, camera, Background.BLACK, true);
    return target.read(studio.gl()).rgba();
  }

  /** Somewhere in a box around the origin; now and then rolled, or off its axis. */
  private Camera camera(double x, double y, double z) {
    Matrix4d view =
        new Matrix4d()
            .rotateZ(random.nextInt(3) == 0 ? random.nextDouble(-0.5, 0.5) : 0)
            .rotateX(random.nextDouble(-0.6, 0.6))
            .rotateY(random.nextDouble(2 * Math.PI))
            .translate(between(x), between(y), between(z));
    double near = random.nextDouble(0.05, 0.15);
    double high = Math.tan(random.nextDouble(0.3, 0.8)) * near;
    double wide = high * WIDTH / HEIGHT;
    double aside = random.nextBoolean() ? 0 : between(wide / 2);
    return new Camera(
        view,
        new Matrix4d().setFrustum(aside - wide, aside + wide, -high, high, near, 60),
        0,
        0,
        WIDTH,
        HEIGHT);
  }

  private double between(double most) {
    return random.nextDouble(-most, most);
  }

  private String walls() {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 25; i++) {
      double gap = Math.pow(10, random.nextDouble(-4, -1));
      double thin = Math.pow(10, random.nextDouble(-5, -1));
      String slab = "<Box size='4 5 " + thin + "'/>";
      place(nodes, shape(slab));
      place(nodes, move(-2 - gap / 2, shape(slab)) + move(2 + gap / 2, shape(slab)));
      place(nodes, shape(frame(Math.pow(10, random.nextDouble(-3, 0)))));
      place(nodes, shape("<Sphere radius='" + random.nextDouble(0.02, 0.6) + "'/>"));
      place(nodes, shape("<Sphere radius='" + random.nextDouble(0.02, 0.6) + "'/>"));
      place(
          nodes,
          "<Shape><Appearance><Material transparency='.5'/></Appearance><Box size='3 3 .1'/>"
              + "</Shape><Shape><PointSet><Coordinate point='0 1 0'/></PointSet></Shape>"
              + "<Shape><IndexedLineSet coordIndex='0 1'><Coordinate point='-1 0 0 1 1 0'/>"
              + "</IndexedLineSet></Shape>");
    }
    return nodes.toString();
  }

  /** A wall with a hole, seen from one side or both. */
  private String frame(double hole) {
    return String.format(
        Locale.ROOT,
        "<IndexedFaceSet solid='%2$b' coordIndex='0 1 5 4 -1 1 2 6 5 -1 2 3 7 6 -1 3 0 4 7'>"
            + "<Coordinate point='-3 -2 0 3 -2 0 3 2 0 -3 2 0 -%1$f -%1$f 0 %1$f -%1$f 0"
            + " %1$f %1$f 0 -%1$f %1$f 0'/></IndexedFaceSet>",
        hole,
        random.nextBoolean());
  }

  private String shape(String geometry) {
    return String.format(
        Locale.ROOT,
        "<Shape><Appearance><Material emissiveColor='%f %f %f'/></Appearance>%s</Shape>",
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        geometry);
  }

  private static String move(double x, String node) {
    return "<Transform translation='" + x + " 0 0'>" + node + "</Transform>";
  }

  /** Anywhere, turned, now and then mirrored and sheared. */
  private void place(StringBuilder out, String nodes) {
    out.append(
        String.format(
            Locale.ROOT,
            "<Transform translation='%f %f %f' rotation='%f 1 %f %f' scale='%f 1 %f'"
                + " scaleOrientation='1 1 0 0.6'>%s</Transform>",
            between(9),
            between(3),
            between(9),
            between(0.3),
            between(0.3),
            random.nextDouble(6),
            random.nextInt(4) == 0 ? -1.5 : 1,
            random.nextInt(4) == 0 ? 0.5 : 1,
            nodes));
  }
}
