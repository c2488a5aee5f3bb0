package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.BufferPool;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.ShaderProgram;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * Draws lines of text on a translucent dark panel in the upper left corner. Letters are triangles,
 * so that no fonts of the machine are needed. Belongs to the thread that owns the context.
 */
public final class TextOverlay {
  private static final float TEXT_SIZE = 15;
  private static final float LINE_HEIGHT = 20;
  private static final float MARGIN = 10;
  private static final float[] PANEL = {0, 0, 0, 0.65f};
  private static final float[] TEXT = {1, 1, 1, 1};

  /** The mesh of a line of text; empty lines have none. */
  private record Line(@Nullable GpuMesh mesh, float width) {}

  private final TextMesher mesher;
  private final Map<String, Line> lines = new HashMap<>();
  private final BufferPool buffers = new BufferPool();
  private @Nullable ShaderProgram program;
  private @Nullable GpuMesh panel;

  public TextOverlay(TextMesher mesher) {
    this.mesher = mesher;
  }

  /**
   * Draws over the framebuffer.
   *
   * @param text the lines from top to bottom; nothing is drawn when there are none
   * @param width of the framebuffer in pixels
   * @param height of the framebuffer in pixels
   * @param scale pixels per unit of the desktop; letters are larger on denser displays
   */
  public void draw(GL3 gl, List<String> text, int width, int height, float scale) {
    if (text.isEmpty()) {
      return;
    }
    if (program == null) {
      program = new ShaderProgram(gl, "overlay", List.of());
      panel = new GpuMesh(gl, MeshPacker.pack(square()), buffers);
    }
    forgetAllBut(gl, text);
    float widest = 0;
    for (String line : text) {
      widest = Math.max(widest, lines.computeIfAbsent(line, key -> make(gl, key)).width());
    }
    gl.glViewport(0, 0, width, height);
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
    program.use(gl);
    Page page = new Page(gl, program, width, height, scale);
    float panelHeight = LINE_HEIGHT * text.size() + MARGIN;
    page.put(panel, PANEL, MARGIN / 2, panelHeight + MARGIN / 2, widest + MARGIN, panelHeight);
    float baseLine = MARGIN + TEXT_SIZE;
    for (String line : text) {
      GpuMesh letters = lines.get(line).mesh();
      if (letters != null) {
        page.put(letters, TEXT, MARGIN, baseLine, 1, 1);
      }
      baseLine += LINE_HEIGHT;
    }
    gl.glBindVertexArray(0);
    gl.glDisable(GL.GL_BLEND);
  }

  /** The window in the desktop's units, measured from the upper left corner. */
  private record Page(GL3 gl, ShaderProgram program, int width, int height, float scale) {
    void put(GpuMesh mesh, float[] color, float x, float y, float sizeX, float sizeY) {
      // Rounded to whole pixels, so that equal letters look equal in all lines.
      float left = Math.round(x * scale);
      float bottom = Math.round(y * scale);
      gl.glUniform4f(
          program.uniform(gl, "place"),
          2 * left / width - 1,
          1 - 2 * bottom / height,
          2 * sizeX * scale / width,
          2 * sizeY * scale / height);
      gl.glUniform4fv(program.uniform(gl, "color"), 1, color, 0);
      mesh.bind(gl);
      gl.glDrawElements(mesh.mode(), mesh.indexCount(), mesh.indexType(), 0);
    }
  }

  private Line make(GL3 gl, String line) {
    Mesh mesh = mesher.mesh(line, FontFamily.SANS, FontStyle.PLAIN, TEXT_SIZE);
    float width = mesher.metrics(line, FontFamily.SANS, FontStyle.PLAIN, TEXT_SIZE).width();
    return new Line(mesh.isEmpty() ? null : new GpuMesh(gl, MeshPacker.pack(mesh), buffers), width);
  }

  private void forgetAllBut(GL3 gl, List<String> text) {
    HashSet<String> wanted = new HashSet<>(text);
    lines
        .entrySet()
        .removeIf(
            entry -> {
              boolean gone = !wanted.contains(entry.getKey());
              if (gone && entry.getValue().mesh() != null) {
                entry.getValue().mesh().dispose(gl);
              }
              return gone;
            });
  }

  private static Mesh square() {
    float[] corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    int[] indices = {0, 1, 2, 0, 2, 3};
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        corners,
        null,
        null,
        null,
        indices,
        false,
        Mesh.boundsOf(corners, indices));
  }

  public void dispose(GL3 gl) {
    forgetAllBut(gl, List.of());
    if (program != null) {
      program.dispose(gl);
      program = null;
    }
    if (panel != null) {
      panel.dispose(gl);
      panel = null;
    }
    buffers.dispose(gl);
  }
}
