package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4d;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshTransformer;
import org.selectiverenderer.render.gpu.BufferPool;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.ShaderProgram;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.PackedMesh;

/**
 * Draws all triangles of a scene by one call with an unlit shader: the baseline that shows how much
 * time a frame needs in the driver alone. Only back faces are culled. Belongs to the thread that
 * owns the context.
 */
public final class BaselineRenderer {
  private final ShaderProgram program;
  private final BufferPool buffers = new BufferPool();
  private final GpuMesh mesh;
  private final float[] numbers = new float[16];

  /**
   * @param triangles the triangles, as {@link #pack} returns them
   */
  public BaselineRenderer(GL3 gl, PackedMesh triangles) {
    program = new ShaderProgram(gl, "raw", List.of());
    mesh = new GpuMesh(gl, triangles, buffers);
  }

  /**
   * Packs the triangles of all shapes shown, with a position and a normal per vertex in the world's
   * coordinates; any thread.
   */
  public static PackedMesh pack(InstanceTree tree) {
    List<Mesh> placed = new ArrayList<>();
    for (ShapeInstance shape : tree.shapes()) {
      if (shape.shown()) {
        shape
            .mesh()
            .filter(one -> one.primitive() == Mesh.Primitive.TRIANGLES)
            .ifPresent(one -> placed.add(MeshTransformer.place(one, shape.world())));
      }
    }
    float[] positions = new float[placed.stream().mapToInt(one -> one.positions().length).sum()];
    float[] normals = new float[positions.length];
    int[] indices = new int[placed.stream().mapToInt(one -> one.indices().length).sum()];
    int vertex = 0;
    int index = 0;
    for (Mesh one : placed) {
      System.arraycopy(one.positions(), 0, positions, 3 * vertex, one.positions().length);
      if (one.normals() != null) {
        System.arraycopy(one.normals(), 0, normals, 3 * vertex, one.normals().length);
      }
      int base = vertex;
      int[] numbers = Arrays.stream(one.indices()).map(i -> base + i).toArray();
      System.arraycopy(numbers, 0, indices, index, numbers.length);
      vertex += one.vertexCount();
      index += numbers.length;
    }
    return MeshPacker.pack(
        new Mesh(
            Mesh.Primitive.TRIANGLES,
            positions,
            normals,
            null,
            null,
            indices,
            placed.stream().allMatch(Mesh::solid),
            Mesh.boundsOf(positions, indices)));
  }

  /** Clears the camera's viewport and draws into it. */
  public void draw(GL3 gl, Camera camera) {
    gl.glViewport(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glClearColor(0, 0, 0, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_LESS);
    if (mesh.solid()) {
      gl.glEnable(GL.GL_CULL_FACE);
      gl.glCullFace(GL.GL_BACK);
    }
    program.use(gl);
    camera.projection().mul(camera.view(), new Matrix4d()).get(numbers);
    gl.glUniformMatrix4fv(program.uniform(gl, "place"), 1, false, numbers, 0);
    mesh.bind(gl);
    gl.glDrawElements(mesh.mode(), mesh.indexCount(), mesh.indexType(), 0);
    gl.glBindVertexArray(0);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glDisable(GL.GL_DEPTH_TEST);
  }

  /** Frees its resources on the graphics card. */
  public void dispose(GL3 gl) {
    program.dispose(gl);
    mesh.dispose(gl);
    buffers.dispose(gl);
  }
}
