package org.selectiverenderer.runtime.render.show;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.tessellate.TextMesher;
import org.selectiverenderer.runtime.render.context.PictureCopy;
import org.selectiverenderer.runtime.render.context.Screenshot;
import org.selectiverenderer.runtime.render.sketch.SketchPainter;
import org.selectiverenderer.runtime.render.window.FrameSize;

/**
 * What an operator's window paints: a page, and in it a copy of what the participant sees. For the
 * thread that draws the window.
 */
public final class OperatorCanvas {
  private final PictureCopy picture = new PictureCopy();
  private final SketchPainter sketch = new SketchPainter(new TextMesher());

  /** The copy of what the participant sees, which who knows of newer ones brings up to date. */
  public PictureCopy picture() {
    return picture;
  }

  /** Darkens the window, before the first page as behind each. */
  public void clear(GL3 gl) {
    gl.glClearColor(0.11f, 0.12f, 0.14f, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
  }

  /**
   * Paints a page over a window that is clear.
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
   * Lets go of what it has in the window's context.
   *
   * @param size of the window, if it was ever drawn
   * @param last draws it once more
   * @return what the window shows then; null when it was never drawn
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
