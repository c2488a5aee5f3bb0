package org.selectiverenderer.render.headset;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.MirroredEye;
import org.selectiverenderer.render.context.OffscreenFramebuffer;

/**
 * Copies a headset's pictures for windows on the desktop, {@value #RATE} times a second, by
 * asynchronous readback: a picture is scaled down and read into a pixel buffer object, which is
 * mapped some frames later when the graphics card has finished, so that neither side waits. All
 * methods except {@link #newest} belong to the headset's thread.
 */
final class MirrorReadback {
  /** Copies a second. */
  static final int RATE = 30;

  private static final long PAUSE = 1_000_000_000L / RATE;
  private static final int WIDEST = 1280;
  private static final int BYTES = 4;

  /**
   * A copy of the headset's picture.
   *
   * @param pixels four bytes per pixel, lowest row first; not written to any more
   */
  record Copy(ByteBuffer pixels, int width, int height, long number) {}

  private final MirroredEye side;
  private final AtomicReference<@Nullable Copy> newest = new AtomicReference<>();
  private @Nullable OffscreenFramebuffer small;
  private int buffer;
  private long fence;
  private long last = System.nanoTime() - PAUSE;
  private long number;

  MirrorReadback(MirroredEye side) {
    this.side = side;
  }

  /** Returns the newest copy; null before the first. Any thread. */
  @Nullable Copy newest() {
    return newest.get();
  }

  /** Publishes a black picture, while the headset shows nothing. */
  void blacken() {
    Copy before = newest.get();
    if (before != null && before.width() != 1) {
      ByteBuffer black = ByteBuffer.allocateDirect(BYTES);
      black.put(BYTES - 1, (byte) 0xff);
      newest.set(new Copy(black, 1, 1, ++number));
    }
  }

  /** Publishes the previous copy when it is ready, and starts the next one if it is time for it. */
  void frame(GL3 gl, OffscreenFramebuffer eyes) {
    publish(gl);
    long now = System.nanoTime();
    if (fence == 0 && now - last >= PAUSE) {
      last = now;
      take(gl, eyes);
    }
  }

  private void take(GL3 gl, OffscreenFramebuffer eyes) {
    int half = eyes.width() / 2;
    int x = side == MirroredEye.RIGHT ? half : 0;
    int partWidth = side == MirroredEye.BOTH ? eyes.width() : half;
    int width = Math.min(WIDEST, partWidth);
    int height = Math.max(1, eyes.height() * width / partWidth);
    OffscreenFramebuffer target = target(gl, width, height);
    eyes.resolve(gl);
    target.bindToDraw(gl);
    gl.glBlitFramebuffer(
        x,
        0,
        x + partWidth,
        eyes.height(),
        0,
        0,
        width,
        height,
        GL.GL_COLOR_BUFFER_BIT,
        width == partWidth ? GL.GL_NEAREST : GL.GL_LINEAR);
    target.resolve(gl);
    gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1);
    gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, buffer);
    gl.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, 0);
    gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, 0);
    fence = gl.glFenceSync(GL3.GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    eyes.bind(gl);
  }

  private OffscreenFramebuffer target(GL3 gl, int width, int height) {
    OffscreenFramebuffer known = small;
    if (known == null || known.width() != width || known.height() != height) {
      dispose(gl);
      known = new OffscreenFramebuffer(gl, width, height, 0);
      small = known;
      int[] id = new int[1];
      gl.glGenBuffers(1, id, 0);
      buffer = id[0];
      gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, buffer);
      gl.glBufferData(
          GL2ES3.GL_PIXEL_PACK_BUFFER, (long) BYTES * width * height, null, GL2ES3.GL_STREAM_READ);
      gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, 0);
    }
    return known;
  }

  private void publish(GL3 gl) {
    OffscreenFramebuffer from = small;
    if (fence == 0 || from == null) {
      return;
    }
    int state = gl.glClientWaitSync(fence, 0, 0);
    if (state == GL3.GL_TIMEOUT_EXPIRED) {
      return;
    }
    gl.glDeleteSync(fence);
    fence = 0;
    gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, buffer);
    ByteBuffer mapped = gl.glMapBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, GL2ES3.GL_READ_ONLY);
    if (mapped != null) {
      ByteBuffer pixels = ByteBuffer.allocateDirect(BYTES * from.width() * from.height());
      pixels.put(0, mapped, 0, pixels.capacity());
      gl.glUnmapBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER);
      newest.set(new Copy(pixels, from.width(), from.height(), ++number));
    }
    gl.glBindBuffer(GL2ES3.GL_PIXEL_PACK_BUFFER, 0);
  }

  void dispose(GL3 gl) {
    if (fence != 0) {
      gl.glDeleteSync(fence);
      fence = 0;
    }
    OffscreenFramebuffer known = small;
    if (known != null) {
      known.dispose(gl);
      small = null;
      gl.glDeleteBuffers(1, new int[] {buffer}, 0);
    }
  }
}
