package org.selectiverenderer.render.preview;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.draw.DrawItem;
import org.selectiverenderer.render.gpu.BufferPool;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.ShaderProgram;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.TriangleClusters;

/**
 * Draws boxes over a preview and the mask of selected shapes. Belongs to the thread that owns the
 * context.
 */
final class PreviewOverlayRenderer {
  /** The opacity of an edge where something hides it. */
  private static final float HIDDEN = 0.3f;

  private static final float[] MASK = {1, 1, 1, 1};
  private static final float[] CORNERS = {
    -.5f, -.5f, -.5f, .5f, -.5f, -.5f, .5f, .5f, -.5f, -.5f, .5f, -.5f,
    -.5f, -.5f, .5f, .5f, -.5f, .5f, .5f, .5f, .5f, -.5f, .5f, .5f
  };
  private static final int[] EDGES = {
    0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7
  };
  private static final int[] SIDES = {
    0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 3, 6, 2, 3, 7, 6, 0, 4, 7, 0, 7, 3, 1, 2,
    6, 1, 6, 5
  };

  private final float[] numbers = new float[16];
  private final Matrix4d place = new Matrix4d();
  private @Nullable ShaderProgram program;
  private final BufferPool buffers = new BufferPool();
  private @Nullable GpuMesh edges;
  private @Nullable GpuMesh sides;

  /** Draws boxes over a picture of the scene with depth test; alpha stays as it is. */
  void boxes(GL3 gl, List<BoxOverlay> boxes, Camera camera) {
    if (boxes.isEmpty()) {
      return;
    }
    ShaderProgram used = begin(gl);
    GpuMesh edgeMesh = edges == null ? upload(gl, Mesh.Primitive.LINES, EDGES) : edges;
    GpuMesh sideMesh = sides == null ? upload(gl, Mesh.Primitive.TRIANGLES, SIDES) : sides;
    edges = edgeMesh;
    sides = sideMesh;
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthMask(false);
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
    // A side in the plane of a floor or wall is drawn whole, not in stripes.
    gl.glPolygonOffset(-1, -16);
    for (BoxOverlay box : boxes) {
      gl.glDepthFunc(GL.GL_LESS);
      gl.glEnable(GL.GL_POLYGON_OFFSET_FILL);
      draw(gl, used, sideMesh, box.place(), box.sides(), camera);
      gl.glDisable(GL.GL_POLYGON_OFFSET_FILL);
      gl.glDepthFunc(GL.GL_LEQUAL);
      draw(gl, used, edgeMesh, box.place(), box.edges(), camera);
      float[] e = box.edges();
      gl.glDepthFunc(GL.GL_GREATER);
      draw(gl, used, edgeMesh, box.place(), new float[] {e[0], e[1], e[2], HIDDEN * e[3]}, camera);
    }
    gl.glDepthFunc(GL.GL_LESS);
    gl.glDisable(GL.GL_BLEND);
    end(gl);
  }

  /** Sets alpha to 1 at the pixels of the masked shapes, visible or hidden, and to 0 elsewhere. */
  void mask(GL3 gl, List<DrawItem> items, Set<ShapeInstance> masked, Camera camera) {
    gl.glColorMask(false, false, false, true);
    gl.glClearColor(0, 0, 0, 0);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
    if (!masked.isEmpty()) {
      ShaderProgram used = begin(gl);
      for (DrawItem item : items) {
        if (item.shape().shown() && masked.contains(item.shape())) {
          draw(gl, used, item.mesh(), item.clusters(), item.place(), MASK, camera);
        }
      }
      end(gl);
    }
    gl.glColorMask(true, true, true, true);
  }

  private ShaderProgram begin(GL3 gl) {
    ShaderProgram used = program == null ? new ShaderProgram(gl, "mark", List.of()) : program;
    program = used;
    used.use(gl);
    gl.glDisable(GL.GL_CULL_FACE);
    return used;
  }

  private static void end(GL3 gl) {
    gl.glBindVertexArray(0);
    gl.glDepthMask(true);
    gl.glDisable(GL.GL_DEPTH_TEST);
  }

  private void draw(
      GL3 gl, ShaderProgram used, GpuMesh mesh, Matrix4dc world, float[] color, Camera camera) {
    draw(gl, used, mesh, mesh.clusters(), world, color, camera);
  }

  private void draw(
      GL3 gl,
      ShaderProgram used,
      GpuMesh mesh,
      TriangleClusters part,
      Matrix4dc world,
      float[] color,
      Camera camera) {
    camera.projection().mul(camera.view(), place).mul(world);
    gl.glUniformMatrix4fv(used.uniform(gl, "place"), 1, false, place.get(numbers), 0);
    gl.glUniform4fv(used.uniform(gl, "color"), 1, color, 0);
    mesh.bind(gl);
    gl.glDrawElements(
        mesh.mode(),
        part.indexCount(),
        mesh.indexType(),
        (long) part.firstIndex()[0] * mesh.indexBytes());
  }

  private GpuMesh upload(GL3 gl, Mesh.Primitive primitive, int[] indices) {
    return new GpuMesh(
        gl,
        MeshPacker.pack(
            new Mesh(
                primitive,
                CORNERS,
                null,
                null,
                null,
                indices,
                false,
                Mesh.boundsOf(CORNERS, indices))),
        buffers);
  }

  void dispose(GL3 gl) {
    if (program != null) {
      program.dispose(gl);
      program = null;
    }
    if (edges != null) {
      edges.dispose(gl);
      edges = null;
    }
    if (sides != null) {
      sides.dispose(gl);
      sides = null;
    }
    buffers.dispose(gl);
  }
}
