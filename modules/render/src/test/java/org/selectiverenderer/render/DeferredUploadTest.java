package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.RequiresDisplay;

/**
 * What is not shown when a scene is new is uploaded in the frames that follow, or when shown; so is
 * what comes into a running scene and is too much for one frame.
 */
@RequiresDisplay
class DeferredUploadTest {
  private static final int VERSIONS = 9;

  /** More triangles in each version than wait for one frame together with those before them. */
  private static final int SIDE = 64;

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  /** A Switch of hilly squares, 8,192 triangles each, of which the first is shown. */
  private static TestScene versions() {
    StringBuilder nodes = new StringBuilder("<Switch DEF='S' whichChoice='0'>");
    for (int version = 0; version < VERSIONS; version++) {
      nodes.append(hills(version));
    }
    return TestScene.of(nodes + "</Switch>");
  }

  private static String hills(int version) {
    return hills(version, SIDE);
  }

  /**
   * @param side the squares of a side, of two triangles each
   */
  private static String hills(int version, int side) {
    StringBuilder heights = new StringBuilder();
    for (int i = 0; i < (side + 1) * (side + 1); i++) {
      heights.append(i * (version + 3) % 7).append(' ');
    }
    return String.format(
        Locale.ROOT,
        "<Transform rotation='1 0 0 1.2' translation='-3 %d 0'><Shape><Appearance>"
            + "<UnlitMaterial emissiveColor='0 0.%d 1'/></Appearance>"
            + "<ElevationGrid xDimension='%d' zDimension='%d' xSpacing='0.1' zSpacing='0.1'"
            + " height='%s'/></Shape></Transform>",
        version % 3,
        version + 1,
        side + 1,
        side + 1,
        heights);
  }

  private byte[] shoot(TestScene scene) {
    GL3 gl = studio.gl();
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(gl, TestImageRenderer.SIZE, TestImageRenderer.SIZE, 0);
    target.bind(gl);
    studio.renderer.follow(gl, scene.tree());
    studio.renderer.draw(
        gl,
        studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())),
        TestImageRenderer.parallel(),
        Background.BLACK,
        false);
    byte[] rgba = target.read(gl).rgba();
    target.dispose(gl);
    return rgba;
  }

  @Test
  void hiddenVersionsArriveAFewWithEachFrameAndThenSwitchingUploadsNothing() {
    TestScene scene = versions();
    shoot(scene);
    assertThat(studio.renderer.uploads()).as("first frame").isEqualTo(1);
    shoot(scene);
    assertThat(studio.renderer.uploads()).as("second frame").isBetween(2L, VERSIONS - 1L);
    for (int frame = 0; frame < VERSIONS; frame++) {
      shoot(scene);
    }
    assertThat(studio.renderer.uploads()).isEqualTo(VERSIONS);
    assertThat(studio.renderer.items()).hasSize(VERSIONS);
    scene.set("S", "whichChoice", VERSIONS - 1);
    shoot(scene);
    assertThat(studio.renderer.uploads()).isEqualTo(VERSIONS);
  }

  @Test
  void aVersionThatStillWaitsIsShownInTheFrameInWhichItsSwitchSaysSo() {
    TestScene scene = versions();
    shoot(scene);
    scene.set("S", "whichChoice", VERSIONS - 1);
    byte[] early = shoot(scene);
    TestScene same = versions();
    same.set("S", "whichChoice", VERSIONS - 1);
    assertThat(early).isEqualTo(studio.shoot(same).rgba());
  }

  @Test
  void whoeverPreparesWaitsForNothing() {
    TestScene scene = versions();
    shoot(scene);
    studio.renderer.prepare(studio.gl(), scene.tree());
    assertThat(studio.renderer.uploads()).isEqualTo(VERSIONS);
  }

  @Test
  void whatGoesWhileItWaitsIsForgotten() {
    TestScene scene = versions();
    shoot(scene);
    scene.set("S", "children", List.of());
    shoot(scene);
    assertThat(studio.renderer.items()).isEmpty();
  }

  /** A group of the versions, all shown, beside a Switch that shows nothing yet. */
  private static TestScene arriving() {
    StringBuilder nodes = new StringBuilder("<Group DEF='G'>");
    for (int version = 0; version < VERSIONS; version++) {
      nodes.append(hills(version));
    }
    return TestScene.of(
        nodes
            + "</Group><Switch DEF='T'><Transform translation='3 -3 0'><Shape><Appearance>"
            + "<UnlitMaterial emissiveColor='1 0 0'/></Appearance><Box/></Shape></Transform>"
            + "</Switch>");
  }

  @Test
  void whatComesShownIntoARunningSceneFollowsAFewWithEachFrame() {
    TestScene scene = arriving();
    List<Node> all = scene.loaded().scene().find("G").orElseThrow().nodes("children");
    scene.set("G", "children", List.of());
    shoot(scene);
    scene.set("G", "children", all);

    shoot(scene);
    assertThat(studio.renderer.items()).hasSizeBetween(1, VERSIONS - 2);
    scene.set("G", "children", all.subList(0, VERSIONS - 1)); // Meanwhile the last one goes.
    byte[] last = {};
    for (int frame = 0; frame < VERSIONS; frame++) {
      last = shoot(scene);
    }

    assertThat(studio.renderer.items()).hasSize(VERSIONS); // The Switch's box is one of them.
    assertThat(last).isEqualTo(studio.shoot(scene).rgba());
  }

  @Test
  void aSwitchThatWasThereBeforeIsNotLateBecauseOthersAre() {
    TestScene scene = arriving();
    List<Node> all = scene.loaded().scene().find("G").orElseThrow().nodes("children");
    scene.set("G", "children", List.of());
    shoot(scene);
    scene.set("G", "children", all);
    shoot(scene);
    int before = studio.renderer.items().size();

    scene.set("T", "whichChoice", 0);
    shoot(scene);

    assertThat(before).isLessThan(VERSIONS);
    assertThat(studio.renderer.items())
        .filteredOn(item -> item.surface().emissive()[0] == 1)
        .hasSize(1);
  }

  @Test
  void aMeshTooLargeForAFrameComesWhenItIsPacked() {
    TestScene scene = TestScene.of("<Group DEF='G'>" + hills(0, 150) + "</Group>");
    List<Node> all = scene.loaded().scene().find("G").orElseThrow().nodes("children");
    scene.set("G", "children", List.of());
    shoot(scene);
    scene.set("G", "children", all);
    byte[] last = shoot(scene);
    assertThat(studio.renderer.items()).as("in the frame in which it comes").isEmpty();
    while (studio.renderer.items().isEmpty()) { // JUnit ends this if it never comes.
      last = shoot(scene);
    }
    assertThat(last).isEqualTo(studio.shoot(scene).rgba());
  }

  @Test
  void allThatANewSceneShowsIsThereInItsFirstFrame() {
    TestScene scene = arriving();
    shoot(scene);
    assertThat(studio.renderer.items()).hasSize(VERSIONS);
  }

  /** Moves a point of a shape of 45,000 triangles, so that it has another mesh. */
  private static void deform(TestScene scene, Node grid, int frame) {
    float[] heights = ((float[]) grid.value(grid.type().indexOf("height"))).clone();
    heights[7] = frame % 5 + 1;
    scene.cascade().send(grid, grid.type().indexOf("set_height"), heights);
    scene.cascade().run();
    scene.tree().update();
  }

  @Test
  void aMeshTooLargeForAFrameComesThoughItChangesWithEachFrame() {
    TestScene scene = TestScene.of("<Group DEF='G'>" + hills(0, 150) + "</Group>");
    List<Node> all = scene.loaded().scene().find("G").orElseThrow().nodes("children");
    Node grid = all.get(0).nodes("children").get(0).node("geometry");
    scene.set("G", "children", List.of());
    shoot(scene);
    scene.set("G", "children", all);
    for (int frame = 0; frame < 40 && studio.renderer.items().isEmpty(); frame++) {
      shoot(scene);
      deform(scene, grid, frame);
    }
    assertThat(studio.renderer.items()).hasSize(1);
  }

  @Test
  void ofAHiddenMeshThatChangesWithEachFrameOnlyTheLatestIsPacked() {
    TestScene scene =
        TestScene.of("<Switch DEF='S' whichChoice='-1'>" + hills(0, 150) + "</Switch>");
    Node grid =
        scene
            .loaded()
            .scene()
            .find("S")
            .orElseThrow()
            .nodes("children")
            .get(0)
            .nodes("children")
            .get(0)
            .node("geometry");
    shoot(scene);
    List<WeakReference<Mesh>> meshes = new ArrayList<>();
    for (int frame = 0; frame < 24; frame++) {
      shoot(scene);
      meshes.add(new WeakReference<>(scene.tree().shapes().get(0).mesh().orElseThrow()));
      deform(scene, grid, frame);
    }
    shoot(scene);
    Eventually.await(
        () -> "meshes of former frames to go, of which " + kept(meshes) + " are in memory",
        () -> {
          System.gc(); // What is being packed is finished meanwhile.
          return kept(meshes) <= 6;
        });
  }

  private static long kept(List<WeakReference<Mesh>> meshes) {
    return meshes.stream().filter(mesh -> mesh.get() != null).count();
  }
}
