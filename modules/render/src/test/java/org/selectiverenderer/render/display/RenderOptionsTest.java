package org.selectiverenderer.render.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** What the user asks for overrules what the scene says. */
@RequiresDisplay
class RenderOptionsTest {
  private static final int SIZE = 60;

  /** A red plate, larger than the picture, lit by the headlight alone. */
  private static final String SCENE =
      "<X3D version='4.0' profile='Full'><Scene>"
          + "<Shape><Appearance><Material ambientIntensity='0' diffuseColor='1 0 0'/></Appearance>"
          + "<Rectangle2D size='20 20'/></Shape></Scene></X3D>";

  /** The colours in the middle row beside the plate's diagonal. */
  private static int beside(RenderOptions style) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
            new SceneLoader(
                NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
        OffscreenView view = OffscreenView.open(SIZE, SIZE, 0, ViewLayout.MONO, style)) {
      World world =
          new World(
              loader.load(
                  "test.x3d",
                  new ByteArrayInputStream(SCENE.getBytes(StandardCharsets.UTF_8)),
                  Path.of("no-such-folder")),
              problems);
      world.step(0, (viewer, time, dt) -> {});
      view.draw(world);
      Screenshot shot = view.screenshot();
      return shot.rgb(SIZE / 4, SIZE / 2) & 0xffffff;
    }
  }

  @Test
  void aWireframeHasNoFaces() throws IOException {
    assertThat(beside(RenderOptions.of(ShadingMode.PIXEL)) >> 16).isGreaterThan(200);
    assertThat(beside(new RenderOptions(ShadingMode.PIXEL, Optional.empty(), true))).isZero();
  }

  @Test
  void theHeadlightIsSwitchedOffWhateverTheSceneSays() throws IOException {
    assertThat(beside(new RenderOptions(ShadingMode.PIXEL, Optional.of(false), false))).isZero();
    assertThat(beside(new RenderOptions(ShadingMode.PIXEL, Optional.of(true), false)) >> 16)
        .isGreaterThan(200);
  }
}
