package org.selectiverenderer.render.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.render.TestImageRenderer;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.tessellate.TextMesher;

@RequiresDisplay
class TextOverlayTest {
  @Test
  void linesStandOnADarkPanelInTheUpperLeft() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      OffscreenFramebuffer target = new OffscreenFramebuffer(studio.gl(), 200, 100, 4);
      target.bind(studio.gl());
      studio.gl().glClearColor(1, 1, 1, 1);
      studio.gl().glClear(com.jogamp.opengl.GL.GL_COLOR_BUFFER_BIT);
      TextOverlay overlay = new TextOverlay(new TextMesher());
      overlay.draw(studio.gl(), List.of("60.0 frames/s", "", "HHH"), 200, 100, 1);
      overlay.draw(studio.gl(), List.of(), 200, 100, 1);
      Screenshot shot = target.read(studio.gl());
      assertThat(shot.rgb(199, 0)).isEqualTo(0xffffff);
      assertThat(shot.rgb(8, 90) & 0xff).isLessThan(100);
      int bright = 0;
      for (int y = 70; y < 95; y++) {
        for (int x = 8; x < 110; x++) {
          bright += (shot.rgb(x, y) & 0xff) > 200 ? 1 : 0;
        }
      }
      assertThat(bright).isBetween(100, 1000);
      overlay.dispose(studio.gl());
      target.dispose(studio.gl());
    }
  }
}
