package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.testing.RequiresDisplay;

/** Two-sided faces of which an eye sees nothing but the front are lit on that side alone. */
@RequiresDisplay
class TwoSidedLightingTest {
  /** Two-sided things under lights: single faces, flat and bent, small ones that share a batch. */
  private static TestScene leaves() {
    Random random = new Random(11);
    StringBuilder nodes =
        new StringBuilder(
            """
            <DirectionalLight direction='1 -2 -3' color='1 0.6 0.3' ambientIntensity='0.1'/>
            <PointLight location='1 2 3' radius='40' color='0.2 0.5 1'/>
            """);
    for (int i = 0; i < 60; i++) {
      nodes.append(
          String.format(
              Locale.ROOT,
              """
              <Transform translation='%f %f %f' rotation='%f %f %f %f' scale='1 1 %d'><Shape>
                <Appearance><Material diffuseColor='%f 0.8 0.5' specularColor='0.3 0.3 0.3'/>
                </Appearance>
                <IndexedFaceSet solid='false' coordIndex='0 1 2 -1 0 2 3 -1' creaseAngle='3'>
                  <Coordinate point='-1 -1 0 1 -1 %f 1 1 0 -1 1 %f'/>
                </IndexedFaceSet></Shape></Transform>
              """,
              random.nextDouble(-8, 8),
              random.nextDouble(-8, 8),
              random.nextDouble(-8, 8),
              random.nextDouble(-1, 1),
              random.nextDouble(-1, 1),
              random.nextDouble(-1, 1),
              random.nextDouble(6),
              i % 4 == 0 ? -1 : 1,
              i % 3 * 0.5,
              i % 5 * 0.3,
              random.nextDouble()));
    }
    return TestScene.of(nodes.toString());
  }

  @ParameterizedTest
  @EnumSource(value = ShadingMode.class, names = "AUTO", mode = EnumSource.Mode.EXCLUDE)
  void whereOnlyFrontsAreSeenTheirLightIsThatOfBothSides(ShadingMode shading) {
    TestScene scene = leaves();
    Random random = new Random(13);
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      for (int trial = 0; trial < 20; trial++) {
        Matrix4d view =
            new Matrix4d()
                .lookAt(
                    new Vector3d(random.nextDouble(-9, 9), random.nextDouble(-9, 9), 12),
                    new Vector3d(random.nextDouble(-6, 6), random.nextDouble(-6, 6), 0),
                    new Vector3d(0, 1, 0));
        Camera camera = TestImageRenderer.perspective(view);
        // An eye on the other side of everything sees the backs of what this one sees the front of.
        Matrix4d opposite =
            new Matrix4d()
                .lookAt(
                    new Vector3d(camera.eye()).normalize(-900),
                    new Vector3d(),
                    new Vector3d(1, 1, 0));
        Camera behind =
            new Camera(opposite, new Matrix4d().setPerspective(0.1, 1, 1, 2000), 0, 0, 64, 64);
        byte[] seenByOne = shoot(studio, scene, List.of(camera));
        assertThat(shoot(studio, scene, List.of(camera, behind))).isEqualTo(seenByOne);
      }
    }
  }

  private static byte[] shoot(TestImageRenderer studio, TestScene scene, List<Camera> eyes) {
    GL3 gl = studio.gl();
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(gl, TestImageRenderer.SIZE, TestImageRenderer.SIZE, 0);
    target.bind(gl);
    studio.renderer.prepare(gl, scene.tree());
    studio.renderer.draw(
        gl, studio.renderer.cull(studio.gl(), eyes), eyes.get(0), Background.BLACK, false);
    byte[] rgba = target.read(gl).rgba();
    target.dispose(gl);
    return rgba;
  }
}
