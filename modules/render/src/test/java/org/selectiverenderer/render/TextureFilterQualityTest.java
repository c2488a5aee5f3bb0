package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.util.Collections;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureSampler;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.TextureFilterQuality;
import org.selectiverenderer.testing.RequiresDisplay;

/** What the driver is told of a texture's filters. */
@RequiresDisplay
class TextureFilterQualityTest {
  private static final int SIDE = 64;
  private static final Texture.Image IMAGE =
      new Texture.Image(SIDE, SIDE, 3, new byte[4 * SIDE * SIDE]);
  private static final CubeTexture CUBE =
      new CubeTexture(Collections.nCopies(CubeTexture.FACES, new CubeTexture.Face(IMAGE, 0)), null);

  private record Filters(int smaller, int larger, float anisotropy) {}

  @Test
  void fineOnesAreTheScenes() {
    assertThat(filters(TextureFilterQuality.FINE, plain()))
        .isEqualTo(new Filters(GL.GL_LINEAR_MIPMAP_LINEAR, GL.GL_LINEAR, 4));
    assertThat(filters(TextureFilterQuality.FINE, sampled(TextureSampler.Minify.LINEAR_LINEAR, 2)))
        .isEqualTo(new Filters(GL.GL_LINEAR_MIPMAP_LINEAR, GL.GL_LINEAR, 2));
    assertThat(filters(TextureFilterQuality.FINE, sampled(TextureSampler.Minify.NEAREST_LINEAR, 1)))
        .isEqualTo(new Filters(GL.GL_NEAREST_MIPMAP_LINEAR, GL.GL_LINEAR, 1));
  }

  @Test
  void quickOnesTakeSamplesOfOneMipmap() {
    Filters quick = new Filters(GL.GL_LINEAR_MIPMAP_NEAREST, GL.GL_LINEAR, 1);

    assertThat(filters(TextureFilterQuality.QUICK, plain())).isEqualTo(quick);
    assertThat(filters(TextureFilterQuality.QUICK, sampled(TextureSampler.Minify.LINEAR_LINEAR, 8)))
        .isEqualTo(quick);
    assertThat(
            filters(TextureFilterQuality.QUICK, sampled(TextureSampler.Minify.NEAREST_LINEAR, 1)))
        .isEqualTo(new Filters(GL.GL_NEAREST_MIPMAP_NEAREST, GL.GL_LINEAR, 1));
  }

  @Test
  void quickOnesLeaveFiltersThatAreCheap() {
    assertThat(filters(TextureFilterQuality.QUICK, sampled(TextureSampler.Minify.NEAREST, 1)))
        .isEqualTo(new Filters(GL.GL_NEAREST, GL.GL_LINEAR, 1));
    assertThat(
            filters(TextureFilterQuality.QUICK, sampled(TextureSampler.Minify.LINEAR_NEAREST, 1)))
        .isEqualTo(new Filters(GL.GL_LINEAR_MIPMAP_NEAREST, GL.GL_LINEAR, 1));
  }

  @Test
  void cubesAreSampledBetweenTwoMipmapsInBothWays() {
    for (TextureFilterQuality filters : TextureFilterQuality.values()) {
      assertThat(filters(filters, CUBE))
          .isEqualTo(new Filters(GL.GL_LINEAR_MIPMAP_LINEAR, GL.GL_LINEAR, 1));
    }
  }

  @Test
  void quickOnesHaveTheMipmapsThatTheDriverMakes() {
    for (int[] size : new int[][] {{16, 16}, {37, 20}, {1, 9}}) {
      byte[] rgba = new byte[4 * size[0] * size[1]];
      new Random(1).nextBytes(rgba);
      Texture texture = new Texture(new Texture.Image(size[0], size[1], 4, rgba), true, true);
      try (OffscreenContext context = OffscreenContext.open()) {
        GL3 gl = context.gl();
        int w = size[0];
        int h = size[1];
        for (int level = 0; w > 0 || h > 0; level++, w /= 2, h /= 2) {
          int bytes = 4 * Math.max(1, w) * Math.max(1, h);
          byte[] made = level(gl, TextureFilterQuality.QUICK, texture, level, bytes);
          byte[] drivers = level(gl, TextureFilterQuality.FINE, texture, level, bytes);
          for (int i = 0; i < bytes; i++) {
            assertThat(made[i] & 0xff)
                .as("level %d of %d x %d", level, size[0], size[1])
                .isCloseTo(drivers[i] & 0xff, within(2 + level));
          }
        }
      }
    }
  }

  private static byte[] level(
      GL3 gl, TextureFilterQuality filters, Texture texture, int level, int bytes) {
    GpuTexture made = new GpuTexture(gl, texture, filters);
    made.bind(gl);
    ByteBuffer pixels = Buffers.newDirectByteBuffer(bytes);
    gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1);
    gl.glGetTexImage(GL.GL_TEXTURE_2D, level, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels);
    assertThat(gl.glGetError()).isZero();
    byte[] copied = new byte[bytes];
    pixels.get(copied);
    made.dispose(gl);
    return copied;
  }

  private static Texture plain() {
    return new Texture(IMAGE, true, true);
  }

  private static Texture sampled(TextureSampler.Minify minify, float anisotropy) {
    return new Texture(
        IMAGE,
        true,
        true,
        new TextureSampler(
            TextureSampler.Boundary.REPEAT,
            TextureSampler.Boundary.REPEAT,
            TextureSampler.Boundary.REPEAT,
            new TextureSampler.Color(0, 0, 0, 0),
            anisotropy,
            minify,
            true));
  }

  private static Filters filters(TextureFilterQuality wanted, TextureSource source) {
    try (OffscreenContext context = OffscreenContext.open()) {
      GL3 gl = context.gl();
      GpuTexture texture = new GpuTexture(gl, source, wanted);
      texture.bind(gl);
      int target = source.cube() ? GL.GL_TEXTURE_CUBE_MAP : GL.GL_TEXTURE_2D;
      int[] of = new int[2];
      gl.glGetTexParameteriv(target, GL.GL_TEXTURE_MIN_FILTER, of, 0);
      gl.glGetTexParameteriv(target, GL.GL_TEXTURE_MAG_FILTER, of, 1);
      float[] anisotropy = new float[1];
      gl.glGetTexParameterfv(target, GL2ES2.GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy, 0);
      texture.dispose(gl);
      return new Filters(of[0], of[1], anisotropy[0]);
    }
  }
}
