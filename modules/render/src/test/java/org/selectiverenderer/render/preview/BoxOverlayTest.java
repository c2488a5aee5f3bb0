package org.selectiverenderer.render.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Boxes that are drawn over a scene. */
@RequiresDisplay
class BoxOverlayTest {
  private static final int WIDTH = 200;
  private static final int HEIGHT = 150;

  @Test
  void aSideInThePlaneOfTheFloorIsDrawnWhole() throws IOException {
    String scene =
        """
        <X3D version='4.0'><Scene>
        <Viewpoint position='0 2.2 7' orientation='1 0 0 -0.2'/>
        <Transform translation='0 -0.1 0'><Shape><Appearance><Material diffuseColor='.8 .8 .7'/>
        </Appearance><Box size='20 0.2 20'/></Shape></Transform>
        </Scene></X3D>
        """;
    ProblemCollector problems = new ProblemCollector();
    try (ScenePreviewRenderer view = ScenePreviewRenderer.open();
        SceneLoader loader =
            new SceneLoader(
                NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      ByteArrayInputStream bytes = new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8));
      World world = new World(loader.load("test", bytes, Path.of("")), problems);
      world.instances().update();
      world.step(0, (viewer, now, dt) -> {});
      Matrix4d area = new Matrix4d().translate(0, 1.25, 0).scale(20, 2.5, 20);
      float[] red = {1, 0, 0, 1};
      BoxOverlay box = new BoxOverlay(area, red, red);
      byte[] pixels =
          view.draw(
                  world,
                  new PreviewOptions(List.of(box), Set.of(), false, Optional.empty()),
                  WIDTH,
                  HEIGHT,
                  0)
              .pixels()
              .rgba();
      int other = 0;
      for (int i = 0; i < pixels.length; i += 4) {
        other += (pixels[i] & 0xFF) == 255 && pixels[i + 1] == 0 && pixels[i + 2] == 0 ? 0 : 1;
      }
      // The viewer stands in the area, whose sides are all around.
      assertThat(other).isZero();
    }
  }
}
