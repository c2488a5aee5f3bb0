package org.selectiverenderer.render.gpu;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Uploads images to the texture that is bound, scaled down where the graphics card's size limit
 * requires it.
 */
final class TextureUpload {
  /** The faces in OpenGL's order +X, -X, +Y, -Y, +Z, -Z, as indices into a CubeTexture's faces. */
  private static final int[] FACES = {3, 2, 4, 5, 1, 0};

  private TextureUpload() {}

  static void plane(GL3 gl, Texture.Image image) {
    int most = limit(gl, GL.GL_MAX_TEXTURE_SIZE);
    int width = Math.min(image.width(), most);
    int height = Math.min(image.height(), most);
    send(gl, GL.GL_TEXTURE_2D, width, height, ImageScaling.to(image, 0, width, height));
  }

  /** Uploads an image with its mipmaps. */
  static void planeWithMipmaps(GL3 gl, Texture.Image image) {
    int most = limit(gl, GL.GL_MAX_TEXTURE_SIZE);
    int width = Math.min(image.width(), most);
    int height = Math.min(image.height(), most);
    MipmapGenerator all =
        new MipmapGenerator(width, height, ImageScaling.to(image, 0, width, height));
    int level = 0;
    do {
      send(gl, GL.GL_TEXTURE_2D, level++, all.width(), all.height(), all.rgba());
    } while (all.next());
  }

  static void volume(GL3 gl, Texture.Image image) {
    int most = limit(gl, GL2ES2.GL_MAX_3D_TEXTURE_SIZE);
    int width = Math.min(image.width(), most);
    int height = Math.min(image.height(), most);
    // If there are too many slices, only every second (third ...) is uploaded.
    int step = (image.layers() + most - 1) / most;
    int depth = (image.layers() + step - 1) / step;
    byte[] all = image.rgba();
    if (width != image.width() || height != image.height() || step > 1) {
      all = new byte[width * height * depth * 4];
      for (int slice = 0; slice < depth; slice++) {
        byte[] one = ImageScaling.to(image, slice * step, width, height);
        System.arraycopy(one, 0, all, slice * one.length, one.length);
      }
    }
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage3D(
        GL3.GL_TEXTURE_3D,
        0,
        GL.GL_RGBA8,
        width,
        height,
        depth,
        0,
        GL.GL_RGBA,
        GL.GL_UNSIGNED_BYTE,
        Buffers.newDirectByteBuffer(all));
  }

  static void cube(GL3 gl, CubeTexture cube) {
    gl.glEnable(GL3.GL_TEXTURE_CUBE_MAP_SEAMLESS);
    int size = 1;
    for (CubeTexture.Face face : cube.faces()) {
      size = Math.max(size, Math.max(face.image().width(), face.image().height()));
    }
    size = Math.min(size, limit(gl, GL.GL_MAX_CUBE_MAP_TEXTURE_SIZE));
    for (int i = 0; i < FACES.length; i++) {
      CubeTexture.Face face = cube.faces().get(FACES[i]);
      byte[] rgba = ImageScaling.to(face.image(), face.layer(), size, size);
      boolean side = i != 2 && i != 3;
      // OpenGL takes faces as seen from outside, beginning at the top left corner.
      send(
          gl,
          GL.GL_TEXTURE_CUBE_MAP_POSITIVE_X + i,
          size,
          size,
          side ? ImageScaling.turnedRound(rgba) : rgba);
    }
  }

  /** Allocates a cube map with black faces; returns its side in pixels. */
  static int emptyCube(GL3 gl, int wanted) {
    gl.glEnable(GL3.GL_TEXTURE_CUBE_MAP_SEAMLESS);
    int size = Math.min(wanted, limit(gl, GL.GL_MAX_CUBE_MAP_TEXTURE_SIZE));
    byte[] black = new byte[4 * size * size];
    for (int i = 3; i < black.length; i += 4) {
      black[i] = -1;
    }
    for (int i = 0; i < FACES.length; i++) {
      send(gl, GL.GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, size, size, black);
    }
    return size;
  }

  private static void send(GL3 gl, int target, int width, int height, byte[] rgba) {
    send(gl, target, 0, width, height, rgba);
  }

  private static void send(GL3 gl, int target, int level, int width, int height, byte[] rgba) {
    gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(
        target,
        level,
        GL.GL_RGBA8,
        width,
        height,
        0,
        GL.GL_RGBA,
        GL.GL_UNSIGNED_BYTE,
        Buffers.newDirectByteBuffer(rgba));
  }

  private static int limit(GL3 gl, int name) {
    int[] value = new int[1];
    gl.glGetIntegerv(name, value, 0);
    return value[0];
  }
}
