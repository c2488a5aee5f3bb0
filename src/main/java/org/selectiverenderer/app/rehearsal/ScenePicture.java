package org.selectiverenderer.app.rehearsal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.walkthrough.Walkthrough;

/** Draws what a participant sees at the begin of an exposure. */
final class ScenePicture {
  private static final int WIDTH = 480;
  private static final int HEIGHT = 360;

  private ScenePicture() {}

  /**
   * Returns the picture as a PNG file's bytes. Needs OpenGL.
   *
   * @throws IOException if the scene cannot be read
   */
  static byte[] png(StudyView view, Study study) throws IOException {
    try (Walkthrough walk = SceneViewer.open(view, study.seed(), study.access(), problem -> {});
        OffscreenView drawn =
            OffscreenView.open(
                WIDTH,
                HEIGHT,
                AntiAliasing.SMOOTH,
                ViewLayout.MONO,
                RenderOptions.of(ShadingMode.AUTO))) {
      World world = walk.world();
      drawn.draw(world);
      drawn.finish();
      Path file = Files.createTempFile("preview", ".png");
      try {
        drawn.screenshot(world, AntiAliasing.SMOOTH).writePng(file);
        return Files.readAllBytes(file);
      } finally {
        Files.delete(file);
      }
    }
  }
}
