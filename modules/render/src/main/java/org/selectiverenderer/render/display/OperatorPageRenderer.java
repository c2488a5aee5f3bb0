package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.CrossContextImage;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.graphics2d.Graphics2dRenderer;
import org.selectiverenderer.render.window.FrameSize;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * Draws the operator's window: a page with a copy of the participant's picture. For the thread that
 * draws the window.
 */
public final class OperatorPageRenderer {
  private final CrossContextImage picture = new CrossContextImage();
  private final Graphics2dRenderer sketch = new Graphics2dRenderer(new TextMesher());

  /** Returns the copy of the participant's picture, which the owner of the window updates. */
  public CrossContextImage picture() {
    return picture;
  }

  /** Clears the window to a dark grey. */
  public void clear(GL3 gl) {
    gl.glClearColor(0.11f, 0.12f, 0.14f, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
  }

  /**
   * Draws a page over the cleared window.
   *
   * @param withPicture whether there is a copy to show
   */
  public void paint(GL3 gl, FrameSize frame, OperatorPage page, boolean withPicture) {
    if (withPicture && page.width() > 0 && page.height() > 0) {
      int bottom = frame.height() - page.y() - page.height();
      picture.show(gl, page.x(), bottom, page.width(), page.height());
    }
    sketch.draw(gl, page.marks(), 0, 0, frame.width(), frame.height());
  }

  /**
   * Frees its resources in the window's context.
   *
   * @param size the size of the window, or null if it was never drawn
   * @param last draws the window once more
   * @return a screenshot of the window; null when it was never drawn
   */
  public @Nullable Screenshot end(GL3 gl, @Nullable FrameSize size, Runnable last) {
    Screenshot shot = null;
    if (size != null) {
      last.run();
      shot = Screenshot.read(gl, size.width(), size.height());
    }
    picture.dispose(gl);
    sketch.dispose(gl);
    return shot;
  }
}
