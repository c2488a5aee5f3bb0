package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.render.graphics2d.Graphics2dRenderer;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** Fades a picture to black. Belongs to the thread that owns the context. */
public final class FadeOverlay {
  private final Graphics2dRenderer sketch = new Graphics2dRenderer(new TextMesher());

  /**
   * Darkens the whole framebuffer.
   *
   * @param darkness 0 for no darkening, 1 for black
   */
  public void draw(GL3 gl, double darkness, int width, int height) {
    int alpha = (int) Math.round(255 * Math.max(0, Math.min(1, darkness)));
    if (alpha > 0) {
      sketch.draw(
          gl,
          List.of(Primitive2D.rectangle(0, 0, width, height, alpha << 24)),
          0,
          0,
          width,
          height);
    }
  }

  public void dispose(GL3 gl) {
    sketch.dispose(gl);
  }
}
