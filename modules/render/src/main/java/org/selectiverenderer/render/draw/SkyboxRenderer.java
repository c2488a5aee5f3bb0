package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.ShaderProgram;
import org.selectiverenderer.render.gpu.TextureFilterQuality;

/** Draws the images of a Background as a skybox behind what is drawn already (X3D 4.0, 24.2.1). */
final class SkyboxRenderer {
  private final Map<Texture.Image, GpuTexture> textures = new IdentityHashMap<>();
  private @Nullable ShaderProgram program;
  private int emptyArray;

  /**
   * Draws the sides that have an image; the caller has set the depth test.
   *
   * @param toClip the matrix from the background's directions to clip coordinates
   */
  void paint(GL3 gl, Background backdrop, Matrix4dc toClip) {
    forget(gl, backdrop);
    if (backdrop.pictures().isEmpty()) {
      return;
    }
    ShaderProgram used = program;
    if (used == null) {
      used = new ShaderProgram(gl, "skybox", List.of());
      program = used;
      int[] array = new int[1];
      gl.glGenVertexArrays(1, array, 0);
      emptyArray = array[0];
    }
    used.use(gl);
    gl.glUniformMatrix4fv(
        used.uniform(gl, "toClip"), 1, false, new Matrix4d(toClip).get(new float[16]), 0);
    gl.glUniform1f(used.uniform(gl, "opacity"), 1 - backdrop.transparency());
    gl.glUniform1i(used.uniform(gl, "image"), 0);
    gl.glBindVertexArray(emptyArray);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
    TextureFilterQuality filters =
        GlInfo.of(gl).software()
            ? TextureFilterQuality.FINE_BY_PROCESSOR
            : TextureFilterQuality.FINE;
    for (Map.Entry<Background.Side, Texture.Image> side : backdrop.pictures().entrySet()) {
      textures
          .computeIfAbsent(
              side.getValue(),
              image -> new GpuTexture(gl, new Texture(image, false, false), filters))
          .bind(gl);
      gl.glUniform3fv(used.uniform(gl, "side"), 3, side(side.getKey()), 0);
      gl.glDrawArrays(GL.GL_TRIANGLE_STRIP, 0, 4);
    }
    gl.glDisable(GL.GL_BLEND);
  }

  /**
   * Returns the centre of a side and the vectors to its image's right and upper edge. The image is
   * upright for a viewer who looks along the side's axis with +Y up; at the top with +Z up, at the
   * bottom with -Z up.
   */
  private static float[] side(Background.Side side) {
    return switch (side) {
      case FRONT -> new float[] {0, 0, -1, 1, 0, 0, 0, 1, 0};
      case BACK -> new float[] {0, 0, 1, -1, 0, 0, 0, 1, 0};
      case LEFT -> new float[] {-1, 0, 0, 0, 0, -1, 0, 1, 0};
      case RIGHT -> new float[] {1, 0, 0, 0, 0, 1, 0, 1, 0};
      case TOP -> new float[] {0, 1, 0, 1, 0, 0, 0, 0, 1};
      case BOTTOM -> new float[] {0, -1, 0, 1, 0, 0, 0, 0, -1};
    };
  }

  /** Returns whether it holds no textures. */
  boolean isEmpty() {
    return textures.isEmpty();
  }

  /** Frees the textures of images that are no longer shown. */
  private void forget(GL3 gl, Background backdrop) {
    if (!textures.isEmpty()) {
      textures
          .entrySet()
          .removeIf(
              known -> {
                boolean gone =
                    backdrop.pictures().values().stream()
                        .noneMatch(shown -> shown == known.getKey());
                if (gone) {
                  known.getValue().dispose(gl);
                }
                return gone;
              });
    }
  }

  void dispose(GL3 gl) {
    forget(gl, Background.BLACK);
    if (program != null) {
      program.dispose(gl);
      gl.glDeleteVertexArrays(1, new int[] {emptyArray}, 0);
      program = null;
    }
  }
}
