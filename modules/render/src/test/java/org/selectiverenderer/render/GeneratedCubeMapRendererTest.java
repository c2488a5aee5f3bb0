package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Mirrors over several frames: when they follow what is before them. */
@RequiresDisplay
class GeneratedCubeMapRendererTest {
  private static final int BLACK = 0;
  private static final int GREEN = 0x00ff00;
  private static final int RED = 0xff0000;

  private static String mirror(double x, String update) {
    return """
        <Transform translation='%s 0 0'><Shape><Appearance><UnlitMaterial/>
        <GeneratedCubeMapTexture size='16' update='%s'/></Appearance>
        <IndexedFaceSet solid='false' coordIndex='0 1 2 3 -1'>
        <Coordinate point='-0.5 -4 0 0.5 -4 0 0.5 4 0 -0.5 4 0'/>
        <TextureCoordinateGenerator mode='CAMERASPACEREFLECTIONVECTOR'/>
        </IndexedFaceSet></Shape></Transform>
        """
        .formatted(x, update);
  }

  /** A scene with a wall behind the eye, in pictures of 64 x 64 of which a pixel is 1/8 wide. */
  private static final class Mirrors implements AutoCloseable {
    private final SceneLoader loader;
    private final OffscreenView view;
    private final World world;
    private double time;

    Mirrors(String nodes) throws IOException {
      String scene =
          """
          <X3D profile='Full' version='4.0'><Scene>
          <OrthoViewpoint fieldOfView='-4 -4 4 4'/>
          %s<Shape><Appearance><UnlitMaterial DEF='WALL' emissiveColor='0 1 0'/></Appearance>
          <IndexedFaceSet solid='false' coordIndex='0 1 2 3 -1'>
          <Coordinate point='-40 -40 15 40 -40 15 40 40 15 -40 40 15'/></IndexedFaceSet></Shape>
          </Scene></X3D>
          """
              .formatted(nodes);
      ProblemCollector problems = new ProblemCollector();
      loader =
          new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
      byte[] bytes = scene.getBytes(StandardCharsets.UTF_8);
      world =
          new World(loader.load("s.x3d", new ByteArrayInputStream(bytes), Path.of("")), problems);
      view = OffscreenView.open(64, 64, 0, ViewLayout.MONO, ShadingMode.AUTO);
    }

    void frame() {
      world.step(time++, (viewer, now, dt) -> {});
      view.draw(world);
    }

    void red() {
      Node wall = world.scene().find("WALL").orElseThrow();
      world.cascade().send(wall, wall.type().indexOf("emissiveColor"), new float[] {1, 0, 0});
    }

    /** What is seen at a place of the mirrors' plane. */
    int at(double x) {
      return view.screenshot().rgb((int) Math.floor(32 + 8 * x), 32);
    }

    @Override
    public void close() {
      view.close();
      loader.close();
    }
  }

  @Test
  void someFollowInEachFrameSomeAreDrawnOnceAndSomeNever() throws IOException {
    try (Mirrors mirrors =
        new Mirrors(mirror(-2, "ALWAYS") + mirror(0, "NEXT_FRAME_ONLY") + mirror(2, "NONE"))) {
      mirrors.frame();
      assertThat(mirrors.at(-2)).isEqualTo(GREEN);
      assertThat(mirrors.at(0)).isEqualTo(GREEN);
      assertThat(mirrors.at(2)).isEqualTo(BLACK);
      mirrors.red();
      mirrors.frame();
      mirrors.frame();
      assertThat(mirrors.at(-2)).isEqualTo(RED);
      assertThat(mirrors.at(0)).isEqualTo(GREEN);
      assertThat(mirrors.at(2)).isEqualTo(BLACK);
    }
  }

  @Test
  void manyTakeTurns() throws IOException {
    StringBuilder row = new StringBuilder();
    for (int i = -3; i <= 2; i++) {
      row.append(mirror(i + 0.5, "ALWAYS"));
    }
    try (Mirrors mirrors = new Mirrors(row.toString())) {
      mirrors.frame();
      assertThat(mirrors.at(0.5)).isEqualTo(GREEN);
      assertThat(mirrors.at(1.5)).isEqualTo(BLACK);
      assertThat(mirrors.at(2.5)).isEqualTo(BLACK);
      mirrors.frame();
      assertThat(mirrors.at(1.5)).isEqualTo(GREEN);
      assertThat(mirrors.at(2.5)).isEqualTo(GREEN);
    }
  }
}
