package org.selectiverenderer.runtime.render.show;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.selectiverenderer.runtime.render.context.PictureCopy;
import org.selectiverenderer.runtime.render.window.FrameSize;
import org.selectiverenderer.runtime.render.window.SideSource;

/** The content of the right eye's window: shows each picture that was copied for it. */
final class EyeWindow implements SideSource {
  private final PictureCopy picture;

  EyeWindow(PictureCopy picture) {
    this.picture = picture;
  }

  @Override
  public boolean wanted() {
    return !picture.isEmpty();
  }

  @Override
  public void draw(GL3 gl, FrameSize size) {
    gl.glClearColor(0, 0, 0, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
    // As large as possible with its aspect ratio, since the monitors of the two eyes may differ.
    double scale =
        Math.min(
            size.width() / (double) picture.width(), size.height() / (double) picture.height());
    int width = (int) Math.round(picture.width() * scale);
    int height = (int) Math.round(picture.height() * scale);
    picture.show(gl, (size.width() - width) / 2, (size.height() - height) / 2, width, height);
  }

  @Override
  public void stop(GL3 gl) {
    picture.dispose(gl);
  }
}
