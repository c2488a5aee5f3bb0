package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.gpu.ShaderProgram;

/** Draws a Background's sky, ground and images behind what is drawn already (X3D 4.0, 24.4.1). */
final class BackgroundRenderer {
  private static final int MAX_STOPS = 32;

  /** The vertical angle of the background that a parallel projection shows. */
  private static final double PARALLEL_ANGLE = Math.PI / 4;

  private @Nullable ShaderProgram program;
  private int emptyArray;
  private final SkyboxRenderer skybox = new SkyboxRenderer();

  /** Clears the viewport, which the caller has set as scissor box, to the backdrop's colour. */
  static void clear(GL3 gl, Background backdrop) {
    float opacity = 1 - backdrop.transparency();
    float[] sky = backdrop.skyColor();
    float[] color = sky.length < 3 ? new float[3] : sky;
    gl.glClearColor(color[0] * opacity, color[1] * opacity, color[2] * opacity, 1);
    gl.glDepthMask(true);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
  }

  /** Fills the pixels that nothing was drawn on, unless clearing did that already. */
  void paint(GL3 gl, Background backdrop, Camera camera) {
    if (backdrop.plain() && backdrop.pictures().isEmpty() && skybox.isEmpty()) {
      return;
    }
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glDepthFunc(GL.GL_LEQUAL);
    gl.glDepthMask(false);
    Matrix4d toClip = toClip(backdrop, camera);
    if (!backdrop.plain()) {
      gradient(gl, backdrop, toClip);
    }
    skybox.paint(gl, backdrop, toClip);
    gl.glDepthMask(true);
    gl.glDepthFunc(GL.GL_LESS);
  }

  /**
   * Blends a transparent background over the layers below, before this layer's shapes are drawn.
   */
  void paintOver(GL3 gl, Background backdrop, Camera camera) {
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glDisable(GL.GL_CULL_FACE);
    Matrix4d toClip = toClip(backdrop, camera);
    // Premultiplied alpha: the shader has multiplied the colours by the opacity.
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendColor(0, 0, 0, 1 - backdrop.transparency());
    gl.glBlendFunc(GL.GL_ONE, GL3.GL_ONE_MINUS_CONSTANT_ALPHA);
    gradient(gl, backdrop, toClip);
    gl.glDisable(GL.GL_BLEND);
    skybox.paint(gl, backdrop, toClip);
  }

  private void gradient(GL3 gl, Background backdrop, Matrix4d toClip) {
    if (program == null) {
      program = new ShaderProgram(gl, "backdrop", List.of("MAX_STOPS " + MAX_STOPS));
      int[] array = new int[1];
      gl.glGenVertexArrays(1, array, 0);
      emptyArray = array[0];
    }
    program.use(gl);
    gl.glUniform3fv(program.uniform(gl, "unproject"), 3, unproject(toClip), 0);
    stops(gl, program, "sky", backdrop.skyColor(), backdrop.skyAngle());
    stops(gl, program, "ground", backdrop.groundColor(), backdrop.groundAngle());
    gl.glUniform1f(program.uniform(gl, "opacity"), 1 - backdrop.transparency());
    gl.glBindVertexArray(emptyArray);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
  }

  /** Returns the matrix from the background's directions to clip coordinates. */
  private static Matrix4d toClip(Background backdrop, Camera camera) {
    Matrix4d rotation = new Matrix4d(camera.view()).setTranslation(0, 0, 0);
    // In a parallel projection all pixels have the same direction.
    Matrix4dc projection =
        camera.projection().m33() == 0
            ? camera.projection()
            : new Matrix4d()
                .setPerspective(PARALLEL_ANGLE, camera.width() / (double) camera.height(), 0.1, 10);
    return projection.mul(rotation, rotation).rotate(backdrop.turn());
  }

  /**
   * Returns the directions in the background's coordinates of one clip unit right, one up, and of
   * the centre of the far plane.
   */
  private static float[] unproject(Matrix4d toClip) {
    Matrix4d inverse = toClip.invert(new Matrix4d());
    Vector4d centre = inverse.transform(new Vector4d(0, 0, 1, 1));
    Vector4d right = inverse.transform(new Vector4d(1, 0, 0, 0));
    Vector4d up = inverse.transform(new Vector4d(0, 1, 0, 0));
    double scale = 1 / Math.sqrt(centre.x * centre.x + centre.y * centre.y + centre.z * centre.z);
    double sign = centre.w < 0 ? -scale : scale;
    return new float[] {
      (float) (right.x * sign), (float) (right.y * sign), (float) (right.z * sign),
      (float) (up.x * sign), (float) (up.y * sign), (float) (up.z * sign),
      (float) (centre.x * sign), (float) (centre.y * sign), (float) (centre.z * sign)
    };
  }

  private static void stops(
      GL3 gl, ShaderProgram program, String name, float[] colors, float[] angles) {
    int count = Math.min(MAX_STOPS, Math.min(colors.length / 3, angles.length + 1));
    float[] stops = new float[4 * Math.max(1, count)];
    for (int i = 0; i < count; i++) {
      System.arraycopy(colors, 3 * i, stops, 4 * i, 3);
      stops[4 * i + 3] = i == 0 ? 0 : angles[i - 1];
    }
    gl.glUniform4fv(program.uniform(gl, name), stops.length / 4, stops, 0);
    gl.glUniform1i(program.uniform(gl, name + "Stops"), count);
  }

  void dispose(GL3 gl) {
    skybox.dispose(gl);
    if (program != null) {
      program.dispose(gl);
      gl.glDeleteVertexArrays(1, new int[] {emptyArray}, 0);
      program = null;
    }
  }
}
