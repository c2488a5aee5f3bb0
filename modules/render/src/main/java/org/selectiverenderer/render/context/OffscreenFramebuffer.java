package org.selectiverenderer.render.context;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;

/**
 * An offscreen framebuffer with eight bits per colour channel, 24 bits of depth, eight bits of
 * stencil, and optionally several samples per pixel.
 */
public final class OffscreenFramebuffer {
  private final int width;
  private final int height;
  private final int samples;
  private final Buffer drawn;
  private final Buffer resolved;

  private record Buffer(int frame, int color, int depth) {}

  /**
   * @param samples samples per pixel; 0 or 1 for no anti-aliasing; at most what the driver allows
   *     is used
   * @throws GLException if the driver cannot make such a framebuffer
   */
  public OffscreenFramebuffer(GL3 gl, int width, int height, int samples) {
    this.width = width;
    this.height = height;
    int[] most = new int[1];
    gl.glGetIntegerv(GL2ES3.GL_MAX_SAMPLES, most, 0);
    this.samples = samples > 1 ? Math.min(samples, most[0]) : 0;
    drawn = make(gl, this.samples);
    resolved = this.samples > 1 ? make(gl, 0) : drawn;
  }

  private Buffer make(GL3 gl, int sampleCount) {
    int[] frame = new int[1];
    int[] render = new int[2];
    gl.glGenFramebuffers(1, frame, 0);
    gl.glGenRenderbuffers(2, render, 0);
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, frame[0]);
    attach(gl, render[0], sampleCount, GL.GL_RGBA8, GL.GL_COLOR_ATTACHMENT0);
    attach(gl, render[1], sampleCount, GL.GL_DEPTH24_STENCIL8, GL3.GL_DEPTH_STENCIL_ATTACHMENT);
    int status = gl.glCheckFramebufferStatus(GL.GL_FRAMEBUFFER);
    if (status != GL.GL_FRAMEBUFFER_COMPLETE) {
      throw new GLException(
          "a frame buffer of %s x %s with %s samples cannot be made (status 0x%x)"
              .formatted(width, height, sampleCount, status));
    }
    return new Buffer(frame[0], render[0], render[1]);
  }

  private void attach(GL3 gl, int render, int sampleCount, int format, int attachment) {
    gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, render);
    gl.glRenderbufferStorageMultisample(GL.GL_RENDERBUFFER, sampleCount, format, width, height);
    gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, attachment, GL.GL_RENDERBUFFER, render);
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** Returns the samples per pixel in use; 0 without anti-aliasing. */
  public int samples() {
    return samples;
  }

  /** Binds the framebuffer for drawing and reading. */
  public void bind(GL3 gl) {
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, drawn.frame);
  }

  /** Binds the framebuffer for drawing only. */
  public void bindToDraw(GL3 gl) {
    gl.glBindFramebuffer(GL2ES3.GL_DRAW_FRAMEBUFFER, drawn.frame);
  }

  /** Resolves the samples of what was drawn, and binds the result for reading. */
  public void resolve(GL3 gl) {
    gl.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, drawn.frame);
    if (resolved != drawn) {
      gl.glBindFramebuffer(GL.GL_DRAW_FRAMEBUFFER, resolved.frame);
      gl.glBlitFramebuffer(
          0, 0, width, height, 0, 0, width, height, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST);
      gl.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, resolved.frame);
    }
  }

  /** Reads what was drawn. The framebuffer stays bound for drawing. */
  public Screenshot read(GL3 gl) {
    resolve(gl);
    Screenshot shot = Screenshot.read(gl, width, height);
    bind(gl);
    return shot;
  }

  /** Waits until everything is drawn (glFinish), where there is no buffer swap. */
  public void finish(GL3 gl) {
    gl.glFinish();
  }

  public void dispose(GL3 gl) {
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0);
    delete(gl, drawn);
    if (resolved != drawn) {
      delete(gl, resolved);
    }
  }

  private static void delete(GL3 gl, Buffer buffer) {
    gl.glDeleteFramebuffers(1, new int[] {buffer.frame}, 0);
    gl.glDeleteRenderbuffers(2, new int[] {buffer.color, buffer.depth}, 0);
  }
}
