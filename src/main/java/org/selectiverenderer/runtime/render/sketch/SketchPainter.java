package org.selectiverenderer.runtime.render.sketch;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tessellate.TextMesher;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.camera.Mark;
import org.selectiverenderer.runtime.camera.Panel;
import org.selectiverenderer.runtime.render.gpu.Program;

/** Draws marks, later ones over earlier ones. Belongs to the thread that owns the context. */
public final class SketchPainter {
  private static final int FLOATS = 6;

  /** Letters kept; a page has fewer. */
  private static final int KEPT = 2000;

  private final TextMesher mesher;
  private final Map<String, Mesh> letters = new HashMap<>();
  private final Matrix4d place = new Matrix4d();
  private final float[] numbers = new float[16];
  private @Nullable Program program;
  private @Nullable Program inWorld;
  private int vertexArray;
  private int buffer;
  private FloatBuffer vertices = Buffers.newDirectFloatBuffer(FLOATS * 3 * 4096);

  public SketchPainter(TextMesher mesher) {
    this.mesher = mesher;
  }

  /**
   * Draws over what is in a part of the frame buffer.
   *
   * @param x left of the part in pixels
   * @param y bottom of the part in pixels
   * @param width of the part, and of the page
   * @param height of the part, and of the page
   */
  public void draw(GL3 gl, List<Mark> marks, int x, int y, int width, int height) {
    if (marks.isEmpty()) {
      return;
    }
    fill(gl, marks);
    Program used = program == null ? new Program(gl, "sketch", List.of()) : program;
    program = used;
    used.use(gl);
    gl.glUniform2f(used.uniform(gl, "page"), width, height);
    show(gl, x, y, width, height);
  }

  /**
   * Draws a page that stands in the world, over what is in the frame buffer.
   *
   * @param camera that looks at it
   */
  public void draw(GL3 gl, Panel panel, Camera camera) {
    if (panel.marks().isEmpty()) {
      return;
    }
    fill(gl, panel.marks());
    Program used = inWorld == null ? new Program(gl, "sketch", List.of("IN_WORLD")) : inWorld;
    inWorld = used;
    used.use(gl);
    camera.projection().mul(camera.view(), place).mul(panel.place());
    gl.glUniformMatrix4fv(used.uniform(gl, "place"), 1, false, place.get(numbers), 0);
    show(gl, camera.x(), camera.y(), camera.width(), camera.height());
  }

  private void fill(GL3 gl, List<Mark> marks) {
    vertices.clear();
    if (letters.size() > KEPT) {
      letters.clear();
    }
    for (Mark mark : marks) {
      add(mark);
    }
    vertices.flip();
    if (vertexArray == 0) {
      start(gl);
    }
  }

  private void show(GL3 gl, int x, int y, int width, int height) {
    gl.glViewport(x, y, width, height);
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer);
    gl.glBufferData(GL.GL_ARRAY_BUFFER, 4L * vertices.limit(), vertices, GL.GL_DYNAMIC_DRAW);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, vertices.limit() / FLOATS);
    gl.glBindVertexArray(0);
    gl.glDisable(GL.GL_BLEND);
  }

  private void start(GL3 gl) {
    int[] ids = new int[2];
    gl.glGenVertexArrays(1, ids, 0);
    gl.glGenBuffers(1, ids, 1);
    vertexArray = ids[0];
    buffer = ids[1];
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer);
    gl.glEnableVertexAttribArray(0);
    gl.glVertexAttribPointer(0, 2, GL.GL_FLOAT, false, 4 * FLOATS, 0);
    gl.glEnableVertexAttribArray(1);
    gl.glVertexAttribPointer(1, 4, GL.GL_FLOAT, false, 4 * FLOATS, 8);
    gl.glBindVertexArray(0);
  }

  private void add(Mark mark) {
    if (mark instanceof Mark.Line line) {
      double dx = line.x1() - line.x0();
      double dy = line.y1() - line.y0();
      double length = Math.hypot(dx, dy);
      if (length > 0) {
        double x = -dy / length * line.width() / 2;
        double y = dx / length * line.width() / 2;
        fan(
            new double[] {
              line.x0() + x,
              line.y0() + y,
              line.x1() + x,
              line.y1() + y,
              line.x1() - x,
              line.y1() - y,
              line.x0() - x,
              line.y0() - y
            },
            line.color());
      }
    } else if (mark instanceof Mark.Area area) {
      fan(area.corners(), area.color());
    } else if (mark instanceof Mark.Text text) {
      write(text);
    }
  }

  private void fan(double[] corners, int color) {
    for (int i = 4; i + 1 < corners.length; i += 2) {
      vertex(corners[0], corners[1], color);
      vertex(corners[i - 2], corners[i - 1], color);
      vertex(corners[i], corners[i + 1], color);
    }
  }

  private void write(Mark.Text text) {
    Mesh mesh =
        letters.computeIfAbsent(
            text.text(), key -> mesher.mesh(key, FontFamily.SANS, FontStyle.PLAIN, 1));
    float[] corners = mesh.positions();
    for (int index : mesh.indices()) {
      vertex(
          text.x() + text.size() * corners[3 * index],
          text.y() - text.size() * corners[3 * index + 1],
          text.color());
    }
  }

  private void vertex(double x, double y, int color) {
    if (vertices.remaining() < FLOATS) {
      FloatBuffer more = Buffers.newDirectFloatBuffer(2 * vertices.capacity());
      more.put(vertices.flip());
      vertices = more;
    }
    vertices.put((float) x).put((float) y);
    vertices.put((color >> 16 & 255) / 255f).put((color >> 8 & 255) / 255f);
    vertices.put((color & 255) / 255f).put((color >>> 24) / 255f);
  }

  /** Frees what it has on the graphics card. */
  public void dispose(GL3 gl) {
    for (Program known : new @Nullable Program[] {program, inWorld}) {
      if (known != null) {
        known.dispose(gl);
      }
    }
    program = null;
    inWorld = null;
    if (vertexArray != 0) {
      gl.glDeleteVertexArrays(1, new int[] {vertexArray}, 0);
      gl.glDeleteBuffers(1, new int[] {buffer}, 0);
      vertexArray = 0;
    }
  }
}
