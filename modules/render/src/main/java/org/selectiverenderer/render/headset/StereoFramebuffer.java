package org.selectiverenderer.render.headset;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.OffscreenFramebuffer;

/**
 * The multisample framebuffer of a headset: both eyes' pictures side by side, copied from there to
 * the swapchain textures of the runtime. Belongs to the headset's thread.
 */
final class StereoFramebuffer {
  private final int samples;
  private @Nullable OffscreenFramebuffer target;
  private int frame;

  StereoFramebuffer(int samples) {
    this.samples = samples;
  }

  /** Binds the framebuffer for drawing, resized if needed. */
  OffscreenFramebuffer bind(GL3 gl, int width, int height) {
    OffscreenFramebuffer known = target;
    if (known == null || known.width() != 2 * width || known.height() != height) {
      dispose(gl);
      known = new OffscreenFramebuffer(gl, 2 * width, height, samples);
      target = known;
      int[] id = new int[1];
      gl.glGenFramebuffers(1, id, 0);
      frame = id[0];
    }
    known.bind(gl);
    return known;
  }

  /** Resolves the samples and binds the result for reading, after the drawing is done. */
  void resolve(GL3 gl) {
    OffscreenFramebuffer drawn = target;
    if (drawn != null) {
      drawn.resolve(gl);
    }
  }

  /**
   * Copies an eye's half of the resolved picture to a texture. Values are copied unchanged even to
   * an sRGB texture, because they are sRGB values.
   *
   * @param eye 0 for the left one, 1 for the right one
   */
  void copy(GL3 gl, int eye, int texture) {
    OffscreenFramebuffer from = target;
    if (from == null) {
      return;
    }
    int half = from.width() / 2;
    gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, frame);
    gl.glFramebufferTexture2D(
        GL3.GL_DRAW_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, texture, 0);
    gl.glBlitFramebuffer(
        eye * half,
        0,
        eye * half + half,
        from.height(),
        0,
        0,
        half,
        from.height(),
        GL.GL_COLOR_BUFFER_BIT,
        GL.GL_NEAREST);
    gl.glFramebufferTexture2D(
        GL3.GL_DRAW_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, 0, 0);
  }

  void dispose(GL3 gl) {
    OffscreenFramebuffer known = target;
    if (known != null) {
      known.dispose(gl);
      gl.glDeleteFramebuffers(1, new int[] {frame}, 0);
      target = null;
    }
  }
}
