package org.selectiverenderer.render.context;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.formats.image.PngEncoder;

/**
 * The pixels of a framebuffer.
 *
 * @param rgba width * height pixels of four bytes r, g, b, a; the first row is the lowest
 */
public record Screenshot(int width, int height, byte[] rgba) {

  /**
   * Returns a picture with a part of another in it.
   *
   * @param fromX the column of this picture that is the first one of the other
   * @param fromY the row of this picture that is the lowest one of the other
   * @param x first column of the part in this picture
   * @param y lowest row of the part in this picture
   */
  public Screenshot with(
      Screenshot other, int fromX, int fromY, int x, int y, int partWidth, int partHeight) {
    byte[] both = rgba.clone();
    for (int row = y; row < y + partHeight; row++) {
      int from = 4 * ((row - fromY) * other.width + x - fromX);
      System.arraycopy(other.rgba, from, both, 4 * (row * width + x), 4 * partWidth);
    }
    return new Screenshot(width, height, both);
  }

  /** Reads the lower left part of the framebuffer that is bound for reading. */
  public static Screenshot read(GL3 gl, int width, int height) {
    ByteBuffer pixels = Buffers.newDirectByteBuffer(width * height * 4);
    gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1);
    gl.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels);
    byte[] bytes = new byte[pixels.capacity()];
    pixels.get(0, bytes);
    return new Screenshot(width, height, bytes);
  }

  /**
   * Returns a pixel's colour as 0xRRGGBB.
   *
   * @param x from the left
   * @param y from the bottom
   */
  public int rgb(int x, int y) {
    int i = 4 * (y * width + x);
    return (rgba[i] & 0xff) << 16 | (rgba[i + 1] & 0xff) << 8 | rgba[i + 2] & 0xff;
  }

  /**
   * Writes a PNG file, without transparency.
   *
   * @throws IOException if the file cannot be written
   */
  public void writePng(Path file) throws IOException {
    byte[] rgb = new byte[3 * width * height];
    for (int y = height - 1, at = 0; y >= 0; y--) {
      for (int x = 0; x < width; x++, at += 3) {
        System.arraycopy(rgba, 4 * (y * width + x), rgb, at, 3);
      }
    }
    AtomicFileWriter.write(file, PngEncoder.of(width, height, rgb));
  }
}
