package org.selectiverenderer.render.context;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/**
 * A picture that is copied from one GL context to another through main memory, because the screens
 * of an X server and graphics cards of different vendors cannot share textures. The memory is
 * reused for each picture. Belongs to the thread that owns both contexts.
 */
public final class CrossContextImage {
  private static final int BYTES = 4;

  private ByteBuffer pixels = Buffers.newDirectByteBuffer(BYTES);
  private int width;
  private int height;
  private int texture;
  private int frame;

  /** Returns whether no picture was taken yet. */
  public boolean isEmpty() {
    return width == 0;
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** Reads a part of the framebuffer that is bound for reading, in the first context. */
  public void take(GL3 gl, int x, int y, int partWidth, int partHeight) {
    int bytes = BYTES * partWidth * partHeight;
    if (pixels.capacity() < bytes) {
      pixels = Buffers.newDirectByteBuffer(bytes);
    }
    width = partWidth;
    height = partHeight;
    pixels.clear();
    gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1);
    gl.glReadPixels(x, y, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels);
  }

  /**
   * Takes a picture that is already in memory.
   *
   * @param of the pixels, four bytes each, lowest row first; direct, and not written to before the
   *     next picture is taken
   */
  public void hold(ByteBuffer of, int ofWidth, int ofHeight) {
    pixels = of;
    width = ofWidth;
    height = ofHeight;
  }

  /**
   * Draws the picture into a part of the framebuffer that is bound for drawing, in the second
   * context, stretched to fill it.
   */
  public void show(GL3 gl, int x, int y, int partWidth, int partHeight) {
    int[] bound = new int[1];
    gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, bound, 0);
    if (texture == 0) {
      int[] id = new int[1];
      gl.glGenTextures(1, id, 0);
      texture = id[0];
      gl.glGenFramebuffers(1, id, 0);
      frame = id[0];
    }
    gl.glBindTexture(GL.GL_TEXTURE_2D, texture);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR);
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    pixels.rewind();
    gl.glTexImage2D(
        GL.GL_TEXTURE_2D,
        0,
        GL.GL_RGBA8,
        width,
        height,
        0,
        GL.GL_RGBA,
        GL.GL_UNSIGNED_BYTE,
        pixels);
    gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, frame);
    gl.glFramebufferTexture2D(
        GL3.GL_READ_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, texture, 0);
    boolean same = width == partWidth && height == partHeight;
    gl.glBlitFramebuffer(
        0,
        0,
        width,
        height,
        x,
        y,
        x + partWidth,
        y + partHeight,
        GL.GL_COLOR_BUFFER_BIT,
        same ? GL.GL_NEAREST : GL.GL_LINEAR);
    gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, bound[0]);
    gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
  }

  /** Frees its resources in the second context. */
  public void dispose(GL3 gl) {
    if (texture != 0) {
      gl.glDeleteTextures(1, new int[] {texture}, 0);
      gl.glDeleteFramebuffers(1, new int[] {frame}, 0);
      texture = 0;
    }
  }
}
