package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.VersionFades;
import org.selectiverenderer.render.gpu.ShaderProgram;

/**
 * Draws versions of objects that are being cross-faded: the new one in a growing share of the
 * pixels, by an ordered pattern, the old one in the others ("screen-door transparency"). The
 * pattern is Bayer's index matrix (An optimum method for two-level rendition of continuous-tone
 * pictures, ICC 1973), written to the stencil buffer; so it works with every shader, also with
 * authors' own, and neither version has to be sorted. Both eyes have the same pattern. Where a
 * framebuffer has no stencil buffer, the new version is drawn alone.
 *
 * <p>Belongs to the thread that owns the context.
 */
final class CrossFadeRenderer {
  private static final int BITS = 6;

  /** The number of shares that can be told apart. */
  private static final int LEVELS = 1 << BITS;

  private static final int ALL = 0xFF;

  private @Nullable ShaderProgram program;
  private int vertexArray;
  private boolean patterned;

  /** Writes the pattern for a view, if something fades in it. */
  void begin(GL3 gl, VisibleSet seen, Camera camera) {
    patterned = !seen.fading.isEmpty() && hasStencil(gl);
    if (!patterned) {
      return;
    }
    ShaderProgram used = start(gl);
    gl.glClearStencil(0);
    gl.glClear(GL.GL_STENCIL_BUFFER_BIT);
    gl.glEnable(GL.GL_STENCIL_TEST);
    gl.glStencilFunc(GL.GL_NEVER, ALL, ALL); // so that colours and depths stay
    gl.glStencilOp(GL.GL_REPLACE, GL.GL_KEEP, GL.GL_KEEP);
    gl.glDisable(GL.GL_CULL_FACE);
    used.use(gl);
    gl.glUniform2i(used.uniform(gl, "corner"), camera.x(), camera.y());
    gl.glBindVertexArray(vertexArray);
    for (int bit = 0; bit < BITS; bit++) {
      gl.glStencilMask(1 << bit);
      gl.glUniform1i(used.uniform(gl, "bit"), bit);
      gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
    }
    gl.glBindVertexArray(0);
    gl.glStencilMask(ALL);
    gl.glStencilOp(GL.GL_KEEP, GL.GL_KEEP, GL.GL_KEEP);
    gl.glDisable(GL.GL_STENCIL_TEST);
  }

  /** Draws what fades in a view for which {@link #begin} was called. */
  void paint(
      GL3 gl, VisibleSet seen, boolean blended, Function<VisibleSet, DrawItemRenderer> painters) {
    for (VisibleSet.Fading fading : seen.fading) {
      VisibleSet items = fading.items();
      VersionFades.FadingVersion version = fading.version();
      if (!patterned && !version.coming()) {
        continue;
      }
      if (patterned) {
        gl.glEnable(GL.GL_STENCIL_TEST);
        int level = (int) Math.round(version.threshold() * LEVELS);
        // GL compares the level with the pattern, not the other way round.
        gl.glStencilFunc(version.below() ? GL.GL_GREATER : GL.GL_LEQUAL, level, ALL);
      }
      DrawItemRenderer painter = painters.apply(items);
      if (blended) {
        painter.blend(items.opaque, items.calls.size());
      } else {
        painter.paint(0, items.opaque);
      }
      painter.end();
    }
    gl.glDisable(GL.GL_STENCIL_TEST);
  }

  private static boolean hasStencil(GL3 gl) {
    int[] answer = new int[1];
    gl.glGetIntegerv(GL2ES3.GL_DRAW_FRAMEBUFFER_BINDING, answer, 0);
    int attachment = answer[0] == 0 ? GL3.GL_STENCIL : GL.GL_STENCIL_ATTACHMENT;
    gl.glGetFramebufferAttachmentParameteriv(
        GL2ES3.GL_DRAW_FRAMEBUFFER,
        attachment,
        GL.GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
        answer,
        0);
    if (answer[0] == GL.GL_NONE) {
      return false;
    }
    gl.glGetFramebufferAttachmentParameteriv(
        GL2ES3.GL_DRAW_FRAMEBUFFER,
        attachment,
        GL3.GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE,
        answer,
        0);
    return answer[0] >= BITS;
  }

  private ShaderProgram start(GL3 gl) {
    ShaderProgram known = program;
    if (known != null) {
      return known;
    }
    ShaderProgram made = new ShaderProgram(gl, "dither", List.of());
    int[] ids = new int[1];
    gl.glGenVertexArrays(1, ids, 0);
    vertexArray = ids[0]; // without attributes, but the core profile wants one
    program = made;
    return made;
  }

  /** Frees its resources on the graphics card. */
  void dispose(GL3 gl) {
    ShaderProgram known = program;
    if (known != null) {
      known.dispose(gl);
      gl.glDeleteVertexArrays(1, new int[] {vertexArray}, 0);
      program = null;
    }
  }
}
