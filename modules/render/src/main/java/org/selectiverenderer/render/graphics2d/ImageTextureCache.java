package org.selectiverenderer.render.graphics2d;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.browser.camera.ArgbImage;

/** The textures of the images on pages. Belongs to the thread that owns the context. */
final class ImageTextureCache {
  /** The most cached textures; a page has one image. */
  private static final int KEPT = 8;

  private final Map<ArgbImage, Integer> textures = new HashMap<>();

  /** Binds an image as a mipmapped texture, uploading it if needed. */
  void bind(GL3 gl, ArgbImage picture) {
    Integer known = textures.get(picture);
    if (known != null) {
      gl.glBindTexture(GL.GL_TEXTURE_2D, known);
      return;
    }
    if (textures.size() >= KEPT) {
      dispose(gl);
    }
    int[] id = new int[1];
    gl.glGenTextures(1, id, 0);
    textures.put(picture, id[0]);
    gl.glBindTexture(GL.GL_TEXTURE_2D, id[0]);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR_MIPMAP_LINEAR);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_S, GL.GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_T, GL.GL_CLAMP_TO_EDGE);
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(
        GL.GL_TEXTURE_2D,
        0,
        GL.GL_RGBA8,
        picture.width(),
        picture.height(),
        0,
        GL.GL_RGBA,
        GL.GL_UNSIGNED_BYTE,
        bytes(picture));
    gl.glGenerateMipmap(GL.GL_TEXTURE_2D);
  }

  private static ByteBuffer bytes(ArgbImage picture) {
    ByteBuffer bytes = Buffers.newDirectByteBuffer(4 * picture.width() * picture.height());
    for (int y = 0; y < picture.height(); y++) {
      for (int x = 0; x < picture.width(); x++) {
        int color = picture.color(x, y);
        bytes.put((byte) (color >> 16)).put((byte) (color >> 8));
        bytes.put((byte) color).put((byte) (color >>> 24));
      }
    }
    return bytes.flip();
  }

  void dispose(GL3 gl) {
    for (int texture : textures.values()) {
      gl.glDeleteTextures(1, new int[] {texture}, 0);
    }
    textures.clear();
  }
}
