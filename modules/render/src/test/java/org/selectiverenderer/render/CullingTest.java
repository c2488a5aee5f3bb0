package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
class CullingTest {
  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  private static TestScene balls() {
    Random random = new Random(7);
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 40; i++) {
      nodes.append(
          String.format(
              Locale.ROOT,
              "<Transform translation='%f %f %f' scale='%f 1 0.5' rotation='1 2 3 %f'><Shape>"
                  + "<Appearance><UnlitMaterial emissiveColor='%f %f 1'/></Appearance>"
                  + (i == 0 ? ball() : "<IndexedFaceSet USE='Ball'/>")
                  + "</Shape></Transform>",
              random.nextDouble(-8, 8),
              random.nextDouble(-8, 8),
              random.nextDouble(-8, 8),
              i % 5 == 0 ? -1.5 : 1.5,
              random.nextDouble(6),
              random.nextDouble(),
              random.nextDouble()));
    }
    return TestScene.of(nodes.toString());
  }

  /** A ball of 4,800 triangles, so that it has several clusters. */
  private static String ball() {
    int rows = 40;
    int columns = 60;
    StringBuilder points = new StringBuilder();
    StringBuilder faces = new StringBuilder();
    for (int row = 0; row <= rows; row++) {
      double polar = Math.PI * row / rows;
      for (int column = 0; column < columns; column++) {
        double around = 2 * Math.PI * column / columns;
        points.append(
            String.format(
                Locale.ROOT,
                "%f %f %f ",
                0.8 * Math.sin(polar) * Math.cos(around),
                0.8 * Math.cos(polar),
                -0.8 * Math.sin(polar) * Math.sin(around)));
        int next = (column + 1) % columns;
        int below = (row + 1) * columns;
        if (row < rows) {
          faces.append(row * columns + column).append(' ').append(below + column).append(' ');
          faces.append(below + next).append(' ').append(row * columns + next).append(" -1 ");
        }
      }
    }
    return "<IndexedFaceSet DEF='Ball' coordIndex='%s'><Coordinate point='%s'/></IndexedFaceSet>"
        .formatted(faces, points);
  }

  private static Matrix4d looking(Random random) {
    return new Matrix4d()
        .lookAt(
            new Vector3d(
                random.nextDouble(-6, 6), random.nextDouble(-6, 6), random.nextDouble(-6, 6)),
            new Vector3d(
                random.nextDouble(-6, 6), random.nextDouble(-6, 6), random.nextDouble(-6, 6)),
            new Vector3d(0, 1, 0));
  }

  @Test
  void picturesAreTheSameWithAndWithoutCulling() {
    TestScene scene = balls();
    Random random = new Random(3);
    // Two eyes that look apart: the second sees everything, so nothing is culled for the first.
    Matrix4d all = new Matrix4d().setOrtho(-99, 99, -99, 99, -99, 99);
    long spared = 0;
    for (int trial = 0; trial < 20; trial++) {
      Camera camera = TestImageRenderer.perspective(looking(random));
      byte[] culled = studio.shoot(scene, camera, Background.BLACK, false, 0).rgba();
      long few = studio.renderer.cull(studio.gl(), List.of(camera)).indices();
      Camera everything = new Camera(new Matrix4d(), all, 0, 0, 64, 64);
      Camera behind = new Camera(new Matrix4d().rotateY(Math.PI), all, 0, 0, 64, 64);
      byte[] whole = shoot(scene, List.of(camera, everything, behind));
      assertThat(whole).isEqualTo(culled);
      spared +=
          studio.renderer.cull(studio.gl(), List.of(camera, everything, behind)).indices() - few;
    }
    assertThat(spared).isPositive();
  }

  private byte[] shoot(TestScene scene, List<Camera> eyes) {
    GL3 gl = studio.gl();
    var target = new org.selectiverenderer.render.context.OffscreenFramebuffer(gl, 64, 64, 0);
    target.bind(gl);
    studio.renderer.prepare(gl, scene.tree());
    studio.renderer.draw(
        gl, studio.renderer.cull(studio.gl(), eyes), eyes.get(0), Background.BLACK, false);
    byte[] rgba = target.read(gl).rgba();
    target.dispose(gl);
    return rgba;
  }

  @Test
  void oneListServesTwoEyes() {
    TestScene scene = balls();
    Random random = new Random(5);
    for (int trial = 0; trial < 10; trial++) {
      Matrix4d view = looking(random);
      Camera left = TestImageRenderer.perspective(view.translateLocal(0.5, 0, 0, new Matrix4d()));
      Camera right = TestImageRenderer.perspective(view.translateLocal(-0.5, 0, 0, new Matrix4d()));
      assertThat(shoot(scene, List.of(left, right))).isEqualTo(shoot(scene, List.of(left)));
      assertThat(shoot(scene, List.of(right, left))).isEqualTo(shoot(scene, List.of(right)));
    }
  }

  @Test
  void whatIsNotShownIsNotDrawn() {
    TestScene scene =
        TestScene.of(
            "<Switch DEF='S' whichChoice='-1'><Shape><Box/></Shape></Switch><Shape><Box/></Shape>");
    studio.renderer.prepare(studio.gl(), scene.tree());
    assertThat(studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())).shapes())
        .isEqualTo(1);
    scene.set("S", "whichChoice", 0);
    studio.renderer.prepare(studio.gl(), scene.tree());
    assertThat(studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())).shapes())
        .isEqualTo(2);
  }
}
