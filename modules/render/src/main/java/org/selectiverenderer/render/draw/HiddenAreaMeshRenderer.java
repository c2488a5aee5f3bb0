package org.selectiverenderer.render.draw;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.HiddenAreaMesh;
import org.selectiverenderer.render.gpu.ShaderProgram;

/**
 * Draws the hidden area mesh of a headset: black triangles at the near plane where a lens hides the
 * view, so that the depth test rejects what would be drawn there. Belongs to the thread that owns
 * the context.
 */
final class HiddenAreaMeshRenderer {
  private @Nullable ShaderProgram program;
  private int vertexArray;
  private int buffer;

  /** Draws into the viewport, which was just cleared. */
  void paint(GL3 gl, HiddenAreaMesh hidden) {
    float[] corners = hidden.corners();
    if (corners.length == 0) {
      return;
    }
    ShaderProgram used = start(gl);
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_ALWAYS);
    gl.glDisable(GL.GL_CULL_FACE);
    used.use(gl);
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer);
    gl.glBufferData(
        GL.GL_ARRAY_BUFFER,
        (long) Float.BYTES * corners.length,
        Buffers.newDirectFloatBuffer(corners),
        GL.GL_DYNAMIC_DRAW);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, corners.length / 2);
    gl.glBindVertexArray(0);
  }

  private ShaderProgram start(GL3 gl) {
    ShaderProgram known = program;
    if (known != null) {
      return known;
    }
    ShaderProgram made = new ShaderProgram(gl, "hidden", List.of());
    int[] ids = new int[2];
    gl.glGenVertexArrays(1, ids, 0);
    gl.glGenBuffers(1, ids, 1);
    vertexArray = ids[0];
    buffer = ids[1];
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer);
    gl.glEnableVertexAttribArray(0);
    gl.glVertexAttribPointer(0, 2, GL.GL_FLOAT, false, 2 * Float.BYTES, 0);
    gl.glBindVertexArray(0);
    program = made;
    return made;
  }

  /** Frees its resources on the graphics card. */
  void dispose(GL3 gl) {
    ShaderProgram known = program;
    if (known != null) {
      known.dispose(gl);
      gl.glDeleteVertexArrays(1, new int[] {vertexArray}, 0);
      gl.glDeleteBuffers(1, new int[] {buffer}, 0);
      program = null;
    }
  }
}
