package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;
import org.joml.Matrix4d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.TestImageRenderer;
import org.selectiverenderer.render.TestScene;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.testing.RequiresDisplay;

/**
 * A row of rooms along X, ten units wide, each with a thing and a version of it that its Switch
 * hides: what no eye has seen has no draw items.
 */
@RequiresDisplay
class UnseenShapesTest {
  private static final int ROOMS = 24;

  /** Four walls, a thing and a hidden one. */
  private static final int SHAPES = 6;

  private static final UnseenShapes.Limits LIMITS = new UnseenShapes.Limits(0, 240, 0, 1 << 20);

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();
  private SceneRenderer renderer = new SceneRenderer(2, ShadingMode.PIXEL, LIMITS);
  private TestScene scene = TestScene.of(rooms());

  @AfterEach
  void dispose() {
    renderer.dispose(studio.gl());
  }

  private static String rooms() {
    StringBuilder nodes = new StringBuilder("<Group DEF='ALL'>");
    for (int room = 0; room < ROOMS; room++) {
      nodes.append(
          String.format(
              Locale.ROOT,
              "<Transform translation='%1$d 0 0'>"
                  + wall("-4.9 0 0", "0.1 8 8")
                  + wall("4.9 0 0", "0.1 8 8")
                  + wall("0 0 -4", "10 8 0.1")
                  + wall("0 0 4", "10 8 0.1")
                  + "<Switch DEF='S%2$d' whichChoice='0'>%3$s%4$s</Switch></Transform>",
              10 * room,
              room,
              thing("Sphere", room),
              thing("Box", room)));
    }
    return nodes.append("</Group>").toString();
  }

  private static String wall(String place, String size) {
    return "<Transform translation='%s'><Shape><Appearance><Material/></Appearance><Box size='%s'/></Shape></Transform>"
        .formatted(place, size);
  }

  private static String thing(String geometry, int room) {
    return "<Shape><Appearance><Material diffuseColor='0.%d 0.5 0'/></Appearance><%s/></Shape>"
        .formatted(room % 10, geometry);
  }

  /** The view from a place on the X axis along Z, turned by an angle. */
  private static Camera eye(double x, double turned) {
    return TestImageRenderer.perspective(new Matrix4d().rotateY(turned).translate(-x, 0, -3));
  }

  private byte[] shoot(Camera eye) {
    return shoot(renderer, eye);
  }

  private byte[] shoot(SceneRenderer by, Camera eye) {
    GL3 gl = studio.gl();
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(gl, TestImageRenderer.SIZE, TestImageRenderer.SIZE, 0);
    target.bind(gl);
    by.follow(gl, scene.tree());
    by.draw(gl, by.cull(gl, List.of(eye)), eye, Background.BLACK, true);
    byte[] rgba = target.read(gl).rgba();
    target.dispose(gl);
    return rgba;
  }

  private byte[] expected(Camera eye) {
    SceneRenderer whole = new SceneRenderer(2, ShadingMode.PIXEL);
    byte[] rgba = shoot(whole, eye);
    whole.dispose(studio.gl());
    return rgba;
  }

  private void assertShoots(Camera eye) {
    byte[] shot = shoot(eye);
    byte[] whole = expected(eye);
    int differing = 0;
    for (int i = 0; i < shot.length; i++) {
      differing += Math.abs((shot[i] & 0xff) - (whole[i] & 0xff)) > 8 ? 1 : 0;
    }
    assertThat(differing).as("channels that differ").isLessThan(100);
  }

  @Test
  void onlyTheRoomInWhichTheEyeIsHasItems() {
    assertShoots(eye(0, 0));
    assertThat(renderer.items()).hasSizeBetween(SHAPES - 1, 4 * SHAPES);
  }

  @Test
  void aRoomIsThereInTheFrameInWhichItIsEntered() {
    for (double x = 0; x < 10 * (ROOMS - 1); x += 7) {
      assertShoots(eye(x, x / 5));
    }
    assertThat(renderer.items()).hasSizeGreaterThan(ROOMS * SHAPES / 2);
  }

  @Test
  void whatIsHiddenOfARoomInViewFollowsAndTheRestDoesNot() {
    shoot(eye(0, 0));
    int first = renderer.items().size();
    for (int frame = 0; frame < 5; frame++) {
      shoot(eye(0, 0));
    }
    assertThat(renderer.items()).hasSizeBetween(first + 1, 4 * SHAPES);
  }

  @Test
  void aSwitchInARoomThatNobodySeesUploadsNothing() {
    for (int frame = 0; frame < 5; frame++) {
      shoot(eye(0, 0));
    }
    long uploads = renderer.uploads();
    scene.set("S" + (ROOMS - 1), "whichChoice", 1);
    shoot(eye(0, 0));
    assertThat(renderer.uploads()).isEqualTo(uploads);
    assertShoots(eye(10 * (ROOMS - 1), 0)); // The thing that it shows now.
  }

  @Test
  void whatIsNearIsMadeReadyBeforeItIsSeenAsFarAsThatIsAllowed() {
    renderer.dispose(studio.gl());
    renderer =
        new SceneRenderer(2, ShadingMode.PIXEL, new UnseenShapes.Limits(0, 240, 20_000, 1 << 20));
    shoot(eye(0, 0));
    int first = renderer.items().size();
    int before;
    do { // How many come with a frame depends on the time that they take.
      before = renderer.items().size();
      for (int frame = 0; frame < 5; frame++) {
        shoot(eye(0, 0));
      }
    } while (renderer.items().size() > before);
    assertThat(renderer.items()).hasSizeBetween(first + 1, ROOMS * SHAPES - 1);
    long uploads = renderer.uploads();
    assertShoots(eye(10, 0));
    assertThat(renderer.uploads()).as("the next room was ready").isEqualTo(uploads);
  }

  @Test
  void whatIsFarIsGivenUpWhenThereIsTooMuch() {
    renderer.dispose(studio.gl());
    renderer = new SceneRenderer(2, ShadingMode.PIXEL, new UnseenShapes.Limits(0, 240, 0, 2000));
    for (int room = 0; room < ROOMS; room++) {
      shoot(eye(10 * room, 0));
      shoot(eye(10 * room, 0));
    }
    assertThat(renderer.items()).hasSizeLessThan(ROOMS * SHAPES / 2);
    assertShoots(eye(0, 0));
  }

  @Test
  void whatIsBeingFadedIsInView() {
    renderer.dispose(studio.gl());
    renderer = new SceneRenderer(2, ShadingMode.PIXEL, new UnseenShapes.Limits(0, 240, 0, 100));
    scene =
        TestScene.of(
            "<Transform translation='0 0 -4'><Switch DEF='S' whichChoice='0'>%s%s</Switch></Transform>"
                .formatted(thing("Sphere", 1), thing("Cone", 2)));
    shoot(eye(0, 0));
    Node versions = scene.loaded().scene().find("S").orElseThrow();
    scene.tree().fades().at(0);
    scene.tree().fades().begin(versions, 0, 1, 10);
    scene.set("S", "whichChoice", 1);
    scene.tree().fades().at(5);
    shoot(eye(0, 0));
    shoot(eye(0, 0));
    long uploads = renderer.uploads();
    shoot(eye(0, 0));
    shoot(eye(0, 0));
    assertThat(renderer.uploads()).as("nothing is given up and made again").isEqualTo(uploads);
  }

  @Test
  void ofASceneThatGrowsWhatIsFarIsGivenUp() {
    renderer.dispose(studio.gl());
    renderer = new SceneRenderer(2, ShadingMode.PIXEL, new UnseenShapes.Limits(2000, 240, 0, 2000));
    Node group = scene.loaded().scene().find("ALL").orElseThrow();
    List<Node> all = group.nodes("children");
    scene.set("ALL", "children", all.subList(0, 1));
    shoot(eye(0, 0));
    scene.set("ALL", "children", all);
    shoot(eye(0, 0)); // All come, since a running scene shows what it has got.
    shoot(eye(0, 0));
    assertThat(renderer.items()).hasSizeLessThan(ROOMS * SHAPES / 2);
    assertShoots(eye(10 * (ROOMS - 1), 0));
  }

  @Test
  void preparingMakesAllReady() {
    shoot(eye(0, 0));
    renderer.prepare(studio.gl(), scene.tree());
    assertThat(renderer.items()).hasSize(ROOMS * SHAPES);
    long uploads = renderer.uploads();
    for (int room = 0; room < ROOMS; room++) {
      shoot(eye(10 * room, 0));
    }
    assertThat(renderer.uploads()).isEqualTo(uploads);
  }

  @Test
  void groupsThatComeAndGoLeaveTheOthersUnseen() {
    shoot(eye(0, 0));
    scene.set("S3", "children", List.of());
    assertShoots(eye(0, 0));
    assertThat(renderer.items()).hasSizeBetween(SHAPES - 1, 4 * SHAPES);
    assertShoots(eye(30, 0));
  }

  @Test
  void preparingMakesAllReadyHoweverMuchItIs() {
    renderer.dispose(studio.gl());
    renderer = new SceneRenderer(2, ShadingMode.PIXEL, new UnseenShapes.Limits(0, 240, 0, 2000));
    shoot(eye(0, 0));
    renderer.prepare(studio.gl(), scene.tree());
    assertThat(renderer.items().size()).isEqualTo(ROOMS * SHAPES);
  }

  /** Its vertices are all in the first room, wherever the shape is. */
  private static final String MOVING =
      """
      <Switch><ComposedShader DEF='P' language='GLSL'>
      <ShaderPart type='VERTEX'><![CDATA[
      void main() { gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0); }
      ]]></ShaderPart>
      <ShaderPart type='FRAGMENT'><![CDATA[
      void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }
      ]]></ShaderPart></ComposedShader></Switch>
      """;

  @Test
  void anUnseenShapeThatGetsAProgramIsDrawnWhereverThatMovesIt() {
    scene =
        TestScene.of(
            rooms()
                + "<Transform translation='230 0 0'><Shape><Appearance DEF='A'/><Box/></Shape></Transform>"
                + "<Shape><Appearance DEF='B'>"
                + MOVING.replaceAll("</?Switch>", "")
                + "</Appearance><Box size='0.001 0.001 0.001'/></Shape>");
    shoot(eye(0, 0));
    shoot(eye(0, 0)); // What is hidden in the room follows.
    Node program = scene.loaded().scene().find("P").orElseThrow();
    scene.set("A", "shaders", List.of(program));
    byte[] shot = shoot(eye(0, 0));
    assertThat(renderer.items().stream().filter(DrawItem::anywhere).count()).isEqualTo(2);
    assertThat(shot).isEqualTo(expected(eye(0, 0)));
  }

  @Test
  void anUnseenShapeThatMovesIntoViewIsDrawnInThatFrame() {
    scene =
        TestScene.of(
            rooms()
                + "<Transform DEF='M' translation='230 0 0'><Shape><Appearance><Material"
                + " emissiveColor='1 0 0'/></Appearance><Box/></Shape></Transform>");
    shoot(eye(0, 0));
    scene.set("M", "translation", new float[] {2, 0, 0});
    assertShoots(eye(0, 0));
    assertThat(renderer.items()).hasSizeLessThan(4 * SHAPES);
  }

  @Test
  void whatOnlyTheSecondEyeSeesIsDrawn() {
    GL3 gl = studio.gl();
    List<Camera> eyes = List.of(eye(0, 0), eye(200, 0));
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(gl, TestImageRenderer.SIZE, TestImageRenderer.SIZE, 0);
    target.bind(gl);
    renderer.follow(gl, scene.tree());
    renderer.draw(gl, renderer.cull(gl, eyes), eyes.get(1), Background.BLACK, true);
    byte[] rgba = target.read(gl).rgba();
    target.dispose(gl);
    assertThat(rgba).isEqualTo(expected(eyes.get(1)));
  }
}
