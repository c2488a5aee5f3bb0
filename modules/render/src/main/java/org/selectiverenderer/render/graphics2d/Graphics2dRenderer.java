package org.selectiverenderer.render.graphics2d;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.joml.Matrix4d;
import org.selectiverenderer.browser.camera.ArgbImage;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.ShaderProgram;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * Draws flat graphics (lines, polygons, text, images) over a framebuffer, later ones over earlier
 * ones. Belongs to the thread that owns the context.
 */
public final class Graphics2dRenderer {
  private static final int FLOATS = 6;

  /** The vertices of an image's two triangles. */
  private static final int CORNERS = 6;

  /** The most cached text meshes; a page has fewer. */
  private static final int KEPT = 2000;

  private final TextMesher mesher;
  private final Map<String, Mesh> letters = new HashMap<>();
  private final Matrix4d place = new Matrix4d();
  private final float[] numbers = new float[16];
  private final Map<List<String>, ShaderProgram> programs = new HashMap<>();
  private final ImageTextureCache pictures = new ImageTextureCache();
  private final List<Placed> placed = new ArrayList<>();
  private int vertexArray;
  private int buffer;
  private FloatBuffer vertices = Buffers.newDirectFloatBuffer(FLOATS * 3 * 4096);

  /** An image and the index of its first vertex. */
  private record Placed(ArgbImage pixels, int first) {}

  public Graphics2dRenderer(TextMesher mesher) {
    this.mesher = mesher;
  }

  /**
   * Draws over a part of the framebuffer.
   *
   * @param x the left edge of the part in pixels
   * @param y the bottom edge of the part in pixels
   * @param width of the part, and of the page
   * @param height of the part, and of the page
   */
  public void draw(GL3 gl, List<Primitive2D> marks, int x, int y, int width, int height) {
    draw(gl, new HeadFixedPage(marks, width, height), x, y, width, height);
  }

  /**
   * Draws a page, stretched to a part of the framebuffer.
   *
   * @param x the left edge of the part in pixels
   * @param y the bottom edge of the part in pixels
   */
  public void draw(GL3 gl, HeadFixedPage page, int x, int y, int width, int height) {
    if (page.marks().isEmpty()) {
      return;
    }
    fill(gl, page.marks());
    gl.glViewport(x, y, width, height);
    show(
        gl,
        List.of(),
        used ->
            gl.glUniform2f(used.uniform(gl, "page"), (float) page.width(), (float) page.height()));
  }

  /**
   * Draws a page that stands in the world over the framebuffer.
   *
   * @param camera the camera that sees it
   */
  public void draw(GL3 gl, WorldSpacePanel panel, Camera camera) {
    if (panel.marks().isEmpty()) {
      return;
    }
    fill(gl, panel.marks());
    camera.projection().mul(camera.view(), place).mul(panel.place());
    place.get(numbers);
    gl.glViewport(camera.x(), camera.y(), camera.width(), camera.height());
    show(
        gl,
        List.of("IN_WORLD"),
        used -> gl.glUniformMatrix4fv(used.uniform(gl, "place"), 1, false, numbers, 0));
  }

  private void fill(GL3 gl, List<Primitive2D> marks) {
    vertices.clear();
    placed.clear();
    if (letters.size() > KEPT) {
      letters.clear();
    }
    for (Primitive2D mark : marks) {
      add(mark);
    }
    vertices.flip();
    if (vertexArray == 0) {
      start(gl);
    }
  }

  /**
   * Draws the vertices that {@code fill} has collected.
   *
   * @param kind the defines of the shader program
   * @param page sets the uniforms that place the page
   */
  private void show(GL3 gl, List<String> kind, Consumer<ShaderProgram> page) {
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer);
    gl.glBufferData(GL.GL_ARRAY_BUFFER, 4L * vertices.limit(), vertices, GL.GL_DYNAMIC_DRAW);
    int from = 0;
    for (Placed picture : placed) {
      part(gl, kind, page, from, picture.first);
      gl.glActiveTexture(GL.GL_TEXTURE0);
      pictures.bind(gl, picture.pixels);
      List<String> textured = new ArrayList<>(kind);
      textured.add("PICTURE");
      from = picture.first + CORNERS;
      part(gl, textured, page, picture.first, from);
      gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
    }
    part(gl, kind, page, from, vertices.limit() / FLOATS);
    gl.glBindVertexArray(0);
    gl.glDisable(GL.GL_BLEND);
  }

  private void part(GL3 gl, List<String> kind, Consumer<ShaderProgram> page, int from, int to) {
    if (from == to) {
      return;
    }
    ShaderProgram used =
        programs.computeIfAbsent(kind, wanted -> new ShaderProgram(gl, "sketch", wanted));
    used.use(gl);
    page.accept(used);
    gl.glDrawArrays(GL.GL_TRIANGLES, from, to - from);
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

  private void add(Primitive2D mark) {
    if (mark instanceof Primitive2D.Line line) {
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
    } else if (mark instanceof Primitive2D.Area area) {
      fan(area.corners(), area.color());
    } else if (mark instanceof Primitive2D.Text text) {
      write(text);
    } else if (mark instanceof Primitive2D.Picture picture) {
      place(picture);
    }
  }

  /** Adds an image's corners, with texture coordinates in place of the colour. */
  private void place(Primitive2D.Picture picture) {
    placed.add(new Placed(picture.pixels(), vertices.position() / FLOATS));
    for (int corner : new int[] {0, 1, 3, 0, 3, 2}) {
      int right = corner & 1;
      int down = corner >> 1;
      room();
      vertices.put((float) (picture.x() + right * picture.width()));
      vertices.put((float) (picture.y() + down * picture.height()));
      vertices.put(right).put(down).put(0).put(1);
    }
  }

  private void fan(double[] corners, int color) {
    for (int i = 4; i + 1 < corners.length; i += 2) {
      vertex(corners[0], corners[1], color);
      vertex(corners[i - 2], corners[i - 1], color);
      vertex(corners[i], corners[i + 1], color);
    }
  }

  private void write(Primitive2D.Text text) {
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

  private void room() {
    if (vertices.remaining() < FLOATS) {
      FloatBuffer more = Buffers.newDirectFloatBuffer(2 * vertices.capacity());
      more.put(vertices.flip());
      vertices = more;
    }
  }

  private void vertex(double x, double y, int color) {
    room();
    vertices.put((float) x).put((float) y);
    vertices.put((color >> 16 & 255) / 255f).put((color >> 8 & 255) / 255f);
    vertices.put((color & 255) / 255f).put((color >>> 24) / 255f);
  }

  /** Frees its resources on the graphics card. */
  public void dispose(GL3 gl) {
    programs.values().forEach(known -> known.dispose(gl));
    programs.clear();
    pictures.dispose(gl);
    if (vertexArray != 0) {
      gl.glDeleteVertexArrays(1, new int[] {vertexArray}, 0);
      gl.glDeleteBuffers(1, new int[] {buffer}, 0);
      vertexArray = 0;
    }
  }
}
