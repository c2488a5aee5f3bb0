package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import org.selectiverenderer.runtime.instance.Sampling;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.instance.TextureSource;
import org.selectiverenderer.runtime.instance.VolumeTexture;

/**
 * How textures are sampled: as their TextureProperties say, else trilinearly and a little
 * anisotropically. Or as quickly as does not show, for where a processor samples them: there four
 * samples of an anisotropic filter cost more than all the rest of a pixel.
 */
public enum TextureFilters {
  /** As the scene says. */
  FINE,
  /** The same where a processor draws: smaller versions of images are made by this program. */
  FINE_BY_PROCESSOR,
  /**
   * Of a filter's samples only those of one mipmap, none of them for slanted faces. Cubes stay as
   * they are: mirrors ask for mipmaps between two.
   */
  QUICK;

  private static final float ANISOTROPY = 4;

  /**
   * Pixels a side from which on a texture is filtered anisotropically. It helps what is made
   * smaller; a few pixels are made larger, and then Mesa's software renderer draws arcs with it.
   */
  private static final int ANISOTROPIC_FROM = 32;

  /** Sets those of the texture that is current. */
  void set(GL3 gl, int target, TextureSource source) {
    Sampling sampling = source.sampling();
    if (!(source instanceof Texture texture && halves(texture))) {
      halve(gl, target, source);
    }
    gl.glTexParameteri(
        target,
        GL.GL_TEXTURE_MIN_FILTER,
        minify(sampling == null ? Sampling.Minify.LINEAR_LINEAR : sampling.minify(), fine(source)));
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

  /** Whether the smaller versions of a texture are to come with it: what stands still has some. */
  boolean halves(Texture texture) {
    return this != FINE && texture.image().film() == null && mipmaps(texture);
  }

  private static boolean mipmaps(TextureSource source) {
    Sampling sampling = source.sampling();
    return sampling == null || sampling.minify().mipmaps();
  }

  /** Makes the smaller versions anew, where there are any. */
  static void halve(GL3 gl, int target, TextureSource source) {
    if (mipmaps(source)) {
      gl.glGenerateMipmap(target);
    }
  }

  // Cubes are not filtered so either, unless their author says so: the same renderer draws dots
  // where faces meet.
  private static float anisotropy(TextureSource source) {
    boolean tiny =
        source instanceof Texture texture
            && Math.max(texture.image().width(), texture.image().height()) < ANISOTROPIC_FROM;
    return tiny || source.cube() ? 1 : ANISOTROPY;
  }

  private boolean fine(TextureSource source) {
    return this != QUICK || source.cube();
  }

  private static int minify(Sampling.Minify filter, boolean fine) {
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
    Sampling sampling = source.sampling();
    if (source.cube()) {
      wrap(gl, target, Sampling.Boundary.EDGE, Sampling.Boundary.EDGE, Sampling.Boundary.EDGE);
    } else if (sampling != null) {
      wrap(gl, target, sampling.s(), sampling.t(), sampling.r());
      Sampling.Color c = sampling.border();
      float[] border = {c.r(), c.g(), c.b(), c.a()};
      gl.glTexParameterfv(target, GL3.GL_TEXTURE_BORDER_COLOR, border, 0);
    } else if (source instanceof Texture texture) {
      wrap(gl, target, of(texture.repeatS()), of(texture.repeatT()), Sampling.Boundary.EDGE);
    } else if (source instanceof VolumeTexture volume) {
      wrap(gl, target, of(volume.repeatS()), of(volume.repeatT()), of(volume.repeatR()));
    }
  }

  private static Sampling.Boundary of(boolean repeats) {
    return repeats ? Sampling.Boundary.REPEAT : Sampling.Boundary.EDGE;
  }

  private static void wrap(
      GL3 gl, int target, Sampling.Boundary s, Sampling.Boundary t, Sampling.Boundary r) {
    gl.glTexParameteri(target, GL.GL_TEXTURE_WRAP_S, gl(s));
    gl.glTexParameteri(target, GL.GL_TEXTURE_WRAP_T, gl(t));
    gl.glTexParameteri(target, GL2ES2.GL_TEXTURE_WRAP_R, gl(r));
  }

  private static int gl(Sampling.Boundary boundary) {
    return switch (boundary) {
      case REPEAT -> GL.GL_REPEAT;
      case MIRROR -> GL.GL_MIRRORED_REPEAT;
      case EDGE -> GL.GL_CLAMP_TO_EDGE;
      case BORDER -> GL2ES3.GL_CLAMP_TO_BORDER;
    };
  }
}
