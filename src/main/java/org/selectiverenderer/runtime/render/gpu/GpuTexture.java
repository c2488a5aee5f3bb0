package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import org.selectiverenderer.runtime.instance.Texture;

/** An image on the graphics card with mipmaps, sampled trilinearly and a little anisotropically. */
public final class GpuTexture {
  private static final float ANISOTROPY = 4;

  private final int id;
  private final Alpha alpha;

  /** What the alpha channel of an image is for. */
  public enum Alpha {
    /** Every pixel is opaque. */
    NONE,
    /** Pixels are there or not: an outline cut out of the image. */
    CUT_OUT,
    /** Pixels are translucent. */
    BLENDED
  }

  public GpuTexture(GL3 gl, Texture texture) {
    Texture.Image image = texture.image();
    alpha = alphaOf(image);
    int[] name = new int[1];
    gl.glGenTextures(1, name, 0);
    id = name[0];
    bind(gl);
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(
        GL.GL_TEXTURE_2D,
        0,
        GL.GL_RGBA8,
        image.width(),
        image.height(),
        0,
        GL.GL_RGBA,
        GL.GL_UNSIGNED_BYTE,
        Buffers.newDirectByteBuffer(image.rgba()));
    gl.glGenerateMipmap(GL.GL_TEXTURE_2D);
    parameter(gl, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR_MIPMAP_LINEAR);
    parameter(gl, GL.GL_TEXTURE_MAG_FILTER, GL.GL_LINEAR);
    parameter(gl, GL.GL_TEXTURE_WRAP_S, texture.repeatS() ? GL.GL_REPEAT : GL.GL_CLAMP_TO_EDGE);
    parameter(gl, GL.GL_TEXTURE_WRAP_T, texture.repeatT() ? GL.GL_REPEAT : GL.GL_CLAMP_TO_EDGE);
    if (gl.isExtensionAvailable("GL_EXT_texture_filter_anisotropic")) {
      float[] most = new float[1];
      gl.glGetFloatv(GL2ES2.GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, most, 0);
      gl.glTexParameterf(
          GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAX_ANISOTROPY_EXT, Math.min(ANISOTROPY, most[0]));
    }
  }

  private static void parameter(GL3 gl, int name, int value) {
    gl.glTexParameteri(GL.GL_TEXTURE_2D, name, value);
  }

  public Alpha alpha() {
    return alpha;
  }

  /** What an image's alpha channel is for, judged by its pixels. */
  public static Alpha alphaOf(Texture.Image image) {
    if (!image.translucent()) {
      return Alpha.NONE;
    }
    byte[] rgba = image.rgba();
    int holes = 0;
    int between = 0;
    for (int i = 3; i < rgba.length; i += 4) {
      int a = rgba[i] & 0xff;
      if (a < 16) {
        holes++;
      } else if (a < 240) {
        between++;
      }
    }
    if (holes == 0 && between == 0) {
      return Alpha.NONE;
    }
    // The edges of a cut-out are smoothed over a pixel or two: few pixels lie in between.
    return between * 20 <= rgba.length / 4 && holes > 0 ? Alpha.CUT_OUT : Alpha.BLENDED;
  }

  public void bind(GL3 gl) {
    gl.glActiveTexture(GL.GL_TEXTURE0);
    gl.glBindTexture(GL.GL_TEXTURE_2D, id);
  }

  public void dispose(GL3 gl) {
    gl.glDeleteTextures(1, new int[] {id}, 0);
  }
}
