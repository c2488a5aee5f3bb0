package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.GeneratedCubeTexture;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.browser.instance.VolumeTexture;
import org.selectiverenderer.browser.movie.MoviePlayback;

/** A 2D, 3D or cube map texture on the graphics card. */
public final class GpuTexture {
  private final int id;
  private final int target;
  private final Alpha alpha;
  private final TextureFilterQuality filters;

  /** The texture of a movie; null for a still image. */
  private final @Nullable Texture moving;

  private MoviePlayback.@Nullable Picture seen;

  /** The generated cube map that is rendered into this texture; null for other textures. */
  private final @Nullable GeneratedCubeTexture generated;

  /** The side of a generated cube map in pixels. */
  private int side;

  /** The use of an image's alpha channel. */
  public enum Alpha {
    /** Every pixel is opaque. */
    NONE,
    /** Pixels are either opaque or transparent: a cut-out shape for the alpha test. */
    CUT_OUT,
    /** Pixels are translucent. */
    BLENDED
  }

  public GpuTexture(GL3 gl, TextureSource source, TextureFilterQuality filters) {
    this.filters = filters;
    int[] name = new int[1];
    gl.glGenTextures(1, name, 0);
    id = name[0];
    generated = source instanceof GeneratedCubeTexture cube ? cube : null;
    if (source instanceof Texture texture) {
      target = GL.GL_TEXTURE_2D;
      alpha = alphaOf(texture.image());
      moving = texture.image().film() == null ? null : texture;
      use(gl, 0);
      if (filters.halves(texture)) {
        TextureUpload.planeWithMipmaps(gl, texture.image());
      } else {
        TextureUpload.plane(gl, texture.image());
      }
    } else if (source instanceof VolumeTexture volume) {
      target = GL3.GL_TEXTURE_3D;
      alpha = alphaOf(volume.image());
      moving = null;
      use(gl, 0);
      TextureUpload.volume(gl, volume.image());
    } else if (source instanceof GeneratedCubeTexture cube) {
      target = GL.GL_TEXTURE_CUBE_MAP;
      alpha = Alpha.NONE;
      moving = null;
      use(gl, 0);
      side = TextureUpload.emptyCube(gl, cube.size());
    } else {
      CubeTexture cube = (CubeTexture) source;
      target = GL.GL_TEXTURE_CUBE_MAP;
      alpha = alphaOf(cube.faces().get(0).image());
      moving = null;
      use(gl, 0);
      TextureUpload.cube(gl, cube);
    }
    filters.set(gl, target, source);
  }

  public Alpha alpha() {
    return alpha;
  }

  /** Classifies an image's alpha channel by its pixels. */
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
      return image.film() == null ? Alpha.NONE : Alpha.CUT_OUT; // Later frames may have holes.
    }
    // The edges of a cut-out are anti-aliased over a pixel or two, so few pixels are translucent.
    return between * 20 <= rgba.length / 4 && holes > 0 ? Alpha.CUT_OUT : Alpha.BLENDED;
  }

  public void bind(GL3 gl) {
    bind(gl, 0);
  }

  /** Binds the texture to a texture unit. */
  public void bind(GL3 gl, int unit) {
    use(gl, unit);
    if (moving != null) {
      follow(gl, moving);
    }
  }

  /** Uploads the movie's current frame unless it is there. */
  private void follow(GL3 gl, Texture texture) {
    Texture.Image image = texture.image();
    MoviePlayback.Picture now = Objects.requireNonNull(image.film()).picture();
    if (now != seen) {
      seen = now;
      TextureUpload.plane(
          gl, new Texture.Image(now.width(), now.height(), image.components(), now.rgba()));
      filters.set(gl, target, texture);
    }
  }

  /**
   * Returns the generated cube map that is rendered into this texture; empty for other textures.
   */
  public Optional<GeneratedCubeTexture> generated() {
    return Optional.ofNullable(generated);
  }

  /** Returns the side of a generated cube map in pixels. */
  public int side() {
    return side;
  }

  /**
   * Attaches a face of a generated cube map to the current framebuffer.
   *
   * @param face the face in OpenGL's order +X, -X, +Y, -Y, +Z, -Z
   */
  public void drawOn(GL3 gl, int face) {
    gl.glFramebufferTexture2D(
        GL.GL_FRAMEBUFFER,
        GL.GL_COLOR_ATTACHMENT0,
        GL.GL_TEXTURE_CUBE_MAP_POSITIVE_X + face,
        id,
        0);
  }

  /** Makes the mipmaps after all faces of a generated cube map have been rendered. */
  public void drawn(GL3 gl) {
    if (generated != null) {
      use(gl, 0);
      TextureFilterQuality.halve(gl, target, generated);
    }
  }

  private void use(GL3 gl, int unit) {
    gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
    gl.glBindTexture(target, id);
  }

  public void dispose(GL3 gl) {
    gl.glDeleteTextures(1, new int[] {id}, 0);
  }
}
