package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.joml.Matrix4d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.TestImageRenderer;
import org.selectiverenderer.render.TestScene;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.testing.RequiresDisplay;

/** A renderer that has followed all changes of a scene draws what one draws that is new to it. */
@RequiresDisplay
class IncrementalUpdateTest {
  private static final int SHAPES = 40;
  private static final int LIGHTS = 6;
  private static final int SCENES = 2; // One after the other in the same renderer.
  private static final int STEPS = 60;
  private static final int SIZE = 128;

  /** All shapes have 1,600 triangles to the cost of a small one: some are always given up. */
  private static final UnseenShapes.Limits FEW = new UnseenShapes.Limits(0, 160, 100, 200);

  private enum Waiting {
    NOTHING,
    HIDDEN,
    UNSEEN
  }

  private final Random random = new Random(5);

  @ParameterizedTest
  @CsvSource({
    "PIXEL, NOTHING",
    "PIXEL, UNSEEN",
    "VERTEX, NOTHING",
    "VERTEX, HIDDEN",
    "VERTEX, UNSEEN"
  })
  void whateverChanges(ShadingMode shading, Waiting waiting) {
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      SceneRenderer followed =
          new SceneRenderer(
              2, shading, waiting == Waiting.UNSEEN ? FEW : UnseenShapes.Limits.USUAL);
      for (int i = 0; i < SCENES; i++) {
        followChanges(
            studio.gl(), followed, TestScene.of(nodes()), shading, waiting != Waiting.NOTHING);
      }
      followed.dispose(studio.gl());
    }
  }

  private void followChanges(
      GL3 gl,
      SceneRenderer renderer,
      TestScene scene,
      ShadingMode shading,
      boolean hiddenOnesWait) {
    Node group = scene.loaded().scene().find("G").orElseThrow();
    List<Node> children = group.nodes("children");
    OffscreenFramebuffer target = new OffscreenFramebuffer(gl, SIZE, SIZE, 0);
    for (int step = 0; step < STEPS; step++) {
      for (int i = random.nextInt(4); i >= 0; i--) {
        change(scene, children);
      }
      List<Camera> eyes = eyes();
      SceneRenderer fresh = new SceneRenderer(2, shading);
      List<byte[]> followed = shoot(gl, target, renderer, scene, eyes, hiddenOnesWait);
      List<byte[]> expected = shoot(gl, target, fresh, scene, eyes, false);
      fresh.dispose(gl);
      for (int eye = 0; eye < 2; eye++) {
        assertThat(differing(followed.get(eye), expected.get(eye)))
            .as("channels that differ after step %d", step)
            .isLessThan(100);
      }
    }
    target.dispose(gl);
  }

  private static int differing(byte[] a, byte[] b) {
    int differing = 0;
    for (int i = 0; i < a.length; i++) {
      differing += Math.abs((a[i] & 0xff) - (b[i] & 0xff)) > 8 ? 1 : 0;
    }
    return differing;
  }

  private static List<byte[]> shoot(
      GL3 gl,
      OffscreenFramebuffer target,
      SceneRenderer renderer,
      TestScene scene,
      List<Camera> eyes,
      boolean hiddenOnesWait) {
    target.bind(gl);
    if (hiddenOnesWait) {
      renderer.follow(gl, scene.tree());
    } else {
      renderer.prepare(gl, scene.tree());
    }
    VisibleSet seen = renderer.cull(gl, eyes);
    List<byte[]> shots = new ArrayList<>();
    for (Camera eye : eyes) {
      target.bind(gl);
      renderer.draw(gl, seen, eye, Background.BLACK, false);
      shots.add(target.read(gl).rgba());
    }
    return shots;
  }

  private List<Camera> eyes() {
    Matrix4d view = new Matrix4d().translation(0, 0, -9).rotateX(between(0.5)).rotateY(between(3));
    Matrix4d lens = new Matrix4d().setPerspective(1.2, 1, 0.1, 60);
    return List.of(
        new Camera(view, lens, 0, 0, SIZE, SIZE),
        new Camera(new Matrix4d().translation(-0.3, 0, 0).mul(view), lens, 0, 0, SIZE, SIZE));
  }

  private double between(double most) {
    return random.nextDouble(-most, most);
  }

  private void change(TestScene scene, List<Node> children) {
    String shape = Integer.toString(random.nextInt(SHAPES));
    String light = Integer.toString(random.nextInt(LIGHTS));
    float[] three = {(float) between(4), (float) between(4), (float) between(4)};
    float[] color = {random.nextFloat(), random.nextFloat(), random.nextFloat()};
    switch (random.nextInt(12)) {
      case 0, 1 -> scene.set("T" + shape, "translation", three);
      case 2 -> scene.set("M" + shape, "diffuseColor", color);
      case 3 -> scene.set("M" + shape, "transparency", random.nextBoolean() ? 0f : 0.5f);
      case 4 -> scene.set("S" + shape, "whichChoice", random.nextInt(2));
      case 5 -> scene.set("L" + light, "on", random.nextBoolean());
      case 6 -> scene.set("P" + light, "translation", three);
      case 7 -> scene.set("L" + light, "global", random.nextBoolean());
      case 8 -> scene.set("L" + light, "color", color);
      case 9 -> {
        List<Node> some = new ArrayList<>(children);
        some.removeIf(child -> random.nextInt(6) == 0);
        scene.set("G", "children", some);
      }
      case 10 -> scene.set("T" + shape, "scale", new float[] {random.nextInt(3) - 1, 1, 1});
      default ->
          scene.set(
              "C" + shape,
              "point",
              new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, random.nextInt(2), 1, 0});
    }
  }

  private String nodes() {
    StringBuilder nodes = new StringBuilder("<Group DEF='G'>");
    String[] kinds = {"Point", "Directional", "Spot"};
    for (int i = 0; i < LIGHTS; i++) {
      nodes.append(
          "<Group><Transform DEF='P%1$d'><%2$sLight DEF='L%1$d' %3$s global='false' intensity='0.4'/></Transform></Group>"
              .formatted(i, kinds[i % 3], i % 3 == 1 ? "" : "radius='6'"));
    }
    for (int i = 0; i < SHAPES; i++) {
      String look = "<Appearance><Material DEF='M" + i + "' ambientIntensity='1'/></Appearance>";
      nodes.append(
          String.format(
              Locale.ROOT,
              "<Transform DEF='T%1$d' translation='%2$f %3$f %4$f' rotation='1 1 0 %5$f'>"
                  + "<Switch DEF='S%1$d' whichChoice='0'><Shape>%6$s<Box size='%7$d 1 1'/></Shape>"
                  + "<Shape>%8$s<IndexedFaceSet solid='%9$b' coordIndex='0 1 2 3'>"
                  + "<Coordinate DEF='C%1$d' point='-1 -1 0 1 -1 0 1 1 0 -1 1 0'/></IndexedFaceSet>"
                  + "</Shape></Switch></Transform>",
              i,
              between(4),
              between(4),
              between(4),
              between(3),
              look,
              1 + i % 3,
              "<Appearance><Material USE='M" + i + "'/></Appearance>",
              i % 2 == 0));
    }
    return nodes.append("<DirectionalLight intensity='0.3'/></Group>").toString();
  }
}
