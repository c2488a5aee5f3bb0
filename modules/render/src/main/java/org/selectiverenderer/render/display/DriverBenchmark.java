package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;
import org.joml.Matrix4d;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.draw.BaselineRenderer;
import org.selectiverenderer.render.mesh.MeshPacker;

/**
 * A benchmark of the OpenGL driver: draws unlit triangles without textures and anti-aliasing by one
 * call. Scenes are drawn more slowly, but a machine that is slow here is slow with all of them. The
 * thread that opens it owns its GL context and makes all calls. It takes about a second.
 */
public final class DriverBenchmark implements AutoCloseable {
  /** Columns and rows of the grid of small triangles, two per cell. */
  private static final int COLUMNS = 400;

  private static final int ROWS = 250;

  private static final int WIDTH = 1024;
  private static final int HEIGHT = 768;

  /** The side in pixels of the square picture that measures the fill rate. */
  private static final int SIDE = 2048;

  /** Shorter measurements would be dominated by their start and end. */
  private static final long LEAST_NANOS = 250_000_000;

  private static final int MOST_FRAMES = 1 << 14;

  private final OffscreenContext context = OffscreenContext.open();

  /** Returns the driver that is measured. */
  public GlInfo info() {
    return context.info();
  }

  /** Returns the triangle rate: triangles of four pixels each per second. */
  public double triangles() {
    return perSecond(COLUMNS, ROWS, WIDTH, HEIGHT) * 2 * COLUMNS * ROWS;
  }

  /**
   * Returns the fill rate: pixels per second of two triangles that fill the picture, including its
   * clearing.
   */
  public double pixels() {
    return perSecond(1, 1, SIDE, SIDE) * SIDE * SIDE;
  }

  private double perSecond(int columns, int rows, int width, int height) {
    GL3 gl = context.gl();
    Camera camera = new Camera(new Matrix4d(), new Matrix4d(), 0, 0, width, height);
    OffscreenFramebuffer target = new OffscreenFramebuffer(gl, width, height, 0);
    BaselineRenderer raw = new BaselineRenderer(gl, MeshPacker.pack(sheet(columns, rows)));
    try {
      target.bind(gl);
      seconds(1, raw, camera, target); // Lets the driver compile its shader.
      for (int frames = 1; ; frames *= 2) {
        double seconds = seconds(frames, raw, camera, target);
        if (seconds * 1e9 >= LEAST_NANOS || frames >= MOST_FRAMES) {
          return frames / seconds;
        }
      }
    } finally {
      raw.dispose(gl);
      target.dispose(gl);
    }
  }

  private double seconds(
      int frames, BaselineRenderer raw, Camera camera, OffscreenFramebuffer target) {
    long begun = System.nanoTime();
    for (int frame = 0; frame < frames; frame++) {
      raw.draw(context.gl(), camera);
    }
    target.finish(context.gl());
    return (System.nanoTime() - begun) / 1e9;
  }

  /** Returns a grid of triangles that fills the picture, in clip coordinates. */
  private static Mesh sheet(int columns, int rows) {
    int vertices = (columns + 1) * (rows + 1);
    float[] positions = new float[3 * vertices];
    float[] normals = new float[3 * vertices];
    for (int row = 0, at = 0; row <= rows; row++) {
      for (int column = 0; column <= columns; column++, at += 3) {
        positions[at] = 2f * column / columns - 1;
        positions[at + 1] = 2f * row / rows - 1;
        normals[at + 2] = 1;
      }
    }
    int[] indices = new int[6 * columns * rows];
    for (int row = 0, at = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        int corner = row * (columns + 1) + column;
        int above = corner + columns + 1;
        for (int index : new int[] {corner, corner + 1, above, above, corner + 1, above + 1}) {
          indices[at++] = index;
        }
      }
    }
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        normals,
        null,
        null,
        indices,
        false,
        Mesh.boundsOf(positions, indices));
  }

  @Override
  public void close() {
    context.close();
  }
}
