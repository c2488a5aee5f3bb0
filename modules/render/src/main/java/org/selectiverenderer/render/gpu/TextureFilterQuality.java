package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureSampler;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.browser.instance.VolumeTexture;

/**
 * The quality of texture filtering: as the TextureProperties say, by default trilinear with some
 * anisotropy; or cheaper without a visible difference, for a software renderer, where four samples
 * of an anisotropic filter cost more than all the rest of a pixel.
 */
public enum TextureFilterQuality {
  /** Filters as the scene says; the graphics card makes the mipmaps. */
  FINE,
  /** Filters as the scene says, for a software renderer: this application makes the mipmaps. */
  FINE_BY_PROCESSOR,
  /**
   * Without interpolation between mipmaps and without anisotropy. Cube maps are filtered as the
   * scene says, because reflections need interpolated mipmaps.
   */
  QUICK;

  private static final float ANISOTROPY = 4;

  /**
   * The side in pixels from which on a texture is filtered anisotropically. Smaller textures are
   * mostly magnified, and then Mesa's software renderer draws arcs with anisotropic filters.
   */
  private static final int ANISOTROPIC_FROM = 32;

  /** Sets the filters of the texture that is bound. */
  void set(GL3 gl, int target, TextureSource source) {
    TextureSampler sampling = source.sampling();
    if (!(source instanceof Texture texture && halves(texture))) {
      halve(gl, target, source);
    }
    gl.glTexParameteri(
        target,
        GL.GL_TEXTURE_MIN_FILTER,
        minify(
            sampling == null ? TextureSampler.Minify.LINEAR_LINEAR : sampling.minify(),
            fine(source)));
    boolean linear = sampling == null || sampling.magnifyLinear();
    gl.glTexParameteri(target, GL.GL_TEXTURE_MAG_FILTER, linear ? GL.GL_LINEAR : GL.GL_NEAREST);
    boundaries(gl, target, source);
    float wanted = sampling == null ? anisotropy(source) : sampling.anisotropy();
    if (fine(source)
        && wanted > 1
        && gl.isExtensionAvailable("GL_EXT_texture_filter_anisotropic")) {
      float[] most = new float[1];
      gl.glGetFloatv(GL2ES2.GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, most, 0);
      gl.glTexParameterf(target, GL.GL_TEXTURE_MAX_ANISOTROPY_EXT, Math.min(wanted, most[0]));
    }
  }

  /** Returns whether the mipmaps of a texture are uploaded with it; movies get none. */
  boolean halves(Texture texture) {
    return this != FINE && texture.image().film() == null && mipmaps(texture);
  }

  private static boolean mipmaps(TextureSource source) {
    TextureSampler sampling = source.sampling();
    return sampling == null || sampling.minify().mipmaps();
  }

  /** Generates the mipmaps anew, if the filter uses any. */
  static void halve(GL3 gl, int target, TextureSource source) {
    if (mipmaps(source)) {
      gl.glGenerateMipmap(target);
    }
  }

  // Cube maps are not filtered anisotropically either unless their author says so: the same
  // renderer draws dots where faces meet.
  private static float anisotropy(TextureSource source) {
    boolean tiny =
        source instanceof Texture texture
            && Math.max(texture.image().width(), texture.image().height()) < ANISOTROPIC_FROM;
    return tiny || source.cube() ? 1 : ANISOTROPY;
  }

  private boolean fine(TextureSource source) {
    return this != QUICK || source.cube();
  }

  private static int minify(TextureSampler.Minify filter, boolean fine) {
    return switch (filter) {
      case NEAREST -> GL.GL_NEAREST;
      case LINEAR -> GL.GL_LINEAR;
      case NEAREST_NEAREST -> GL.GL_NEAREST_MIPMAP_NEAREST;
      case NEAREST_LINEAR -> fine ? GL.GL_NEAREST_MIPMAP_LINEAR : GL.GL_NEAREST_MIPMAP_NEAREST;
      case LINEAR_NEAREST -> GL.GL_LINEAR_MIPMAP_NEAREST;
      case LINEAR_LINEAR -> fine ? GL.GL_LINEAR_MIPMAP_LINEAR : GL.GL_LINEAR_MIPMAP_NEAREST;
    };
  }

  private static void boundaries(GL3 gl, int target, TextureSource source) {
    TextureSampler sampling = source.sampling();
    if (source.cube()) {
      wrap(
          gl,
          target,
          TextureSampler.Boundary.EDGE,
          TextureSampler.Boundary.EDGE,
          TextureSampler.Boundary.EDGE);
    } else if (sampling != null) {
      wrap(gl, target, sampling.s(), sampling.t(), sampling.r());
      TextureSampler.Color c = sampling.border();
      float[] border = {c.r(), c.g(), c.b(), c.a()};
      gl.glTexParameterfv(target, GL3.GL_TEXTURE_BORDER_COLOR, border, 0);
    } else if (source instanceof Texture texture) {
      wrap(gl, target, of(texture.repeatS()), of(texture.repeatT()), TextureSampler.Boundary.EDGE);
    } else if (source instanceof VolumeTexture volume) {
      wrap(gl, target, of(volume.repeatS()), of(volume.repeatT()), of(volume.repeatR()));
    }
  }

  private static TextureSampler.Boundary of(boolean repeats) {
    return repeats ? TextureSampler.Boundary.REPEAT : TextureSampler.Boundary.EDGE;
  }

  private static void wrap(
      GL3 gl,
      int target,
      TextureSampler.Boundary s,
      TextureSampler.Boundary t,
      TextureSampler.Boundary r) {
    gl.glTexParameteri(target, GL.GL_TEXTURE_WRAP_S, gl(s));
    gl.glTexParameteri(target, GL.GL_TEXTURE_WRAP_T, gl(t));
    gl.glTexParameteri(target, GL2ES2.GL_TEXTURE_WRAP_R, gl(r));
  }

  private static int gl(TextureSampler.Boundary boundary) {
    return switch (boundary) {
      case REPEAT -> GL.GL_REPEAT;
      case MIRROR -> GL.GL_MIRRORED_REPEAT;
      case EDGE -> GL.GL_CLAMP_TO_EDGE;
      case BORDER -> GL2ES3.GL_CLAMP_TO_BORDER;
    };
  }
}
