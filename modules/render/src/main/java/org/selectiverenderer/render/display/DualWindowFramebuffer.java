package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.CrossContextImage;
import org.selectiverenderer.render.context.OffscreenFramebuffer;

/**
 * An offscreen framebuffer as wide as two windows, for stereo on two monitors: the main window
 * shows its left half, a copy of the right half goes to the right eye's window. Belongs to the
 * render thread.
 */
final class DualWindowFramebuffer {
  private final int samples;
  private @Nullable OffscreenFramebuffer target;

  DualWindowFramebuffer(int samples) {
    this.samples = samples;
  }

  /** Binds the framebuffer for drawing, twice as wide as an eye's window. */
  void bind(GL3 gl, int width, int height) {
    OffscreenFramebuffer known = target;
    if (known == null || known.width() != 2 * width || known.height() != height) {
      dispose(gl);
      known = new OffscreenFramebuffer(gl, 2 * width, height, samples);
      target = known;
    }
    known.bind(gl);
  }

  /** Copies the left half to the window's own framebuffer and the right half to {@code right}. */
  void split(GL3 gl, int window, CrossContextImage right) {
    OffscreenFramebuffer drawn = target;
    if (drawn == null) {
      return;
    }
    int half = drawn.width() / 2;
    drawn.resolve(gl);
    right.take(gl, half, 0, half, drawn.height());
    gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, window);
    gl.glBlitFramebuffer(
        0,
        0,
        half,
        drawn.height(),
        0,
        0,
        half,
        drawn.height(),
        GL.GL_COLOR_BUFFER_BIT,
        GL.GL_NEAREST);
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, window);
  }

  /** Binds both halves for reading. */
  void read(GL3 gl) {
    OffscreenFramebuffer drawn = target;
    if (drawn != null) {
      drawn.resolve(gl);
    }
  }

  void dispose(GL3 gl) {
    OffscreenFramebuffer known = target;
    if (known != null) {
      known.dispose(gl);
      target = null;
    }
  }
}
