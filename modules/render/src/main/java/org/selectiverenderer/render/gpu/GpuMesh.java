package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.render.mesh.RefinementLevelRange;
import org.selectiverenderer.render.mesh.TriangleClusters;
import org.selectiverenderer.render.mesh.VertexLayout;

/** A mesh on the graphics card: a vertex array with its vertex and index buffer. */
public final class GpuMesh {
  private final BufferPool pool;
  private final int vertexArray;
  private final int vertices;
  private final int indices;
  private final int mode;
  private final int indexType;
  private final int indexBytes;
  private final int indexCount;
  private final TriangleClusters clusters;
  private final List<RefinementLevelRange> coarser;
  private final boolean solid;

  /**
   * @param pool the source of the buffer objects, which outlives the mesh
   */
  public GpuMesh(GL3 gl, PackedMesh mesh, BufferPool pool) {
    this.pool = pool;
    mode =
        switch (mesh.primitive()) {
          case TRIANGLES -> GL.GL_TRIANGLES;
          case LINES -> GL.GL_LINES;
          case POINTS -> GL.GL_POINTS;
        };
    indexType = mesh.wideIndices() ? GL.GL_UNSIGNED_INT : GL.GL_UNSIGNED_SHORT;
    indexBytes = mesh.indexBytes();
    indexCount = mesh.indexCount();
    clusters = mesh.clusters();
    coarser = mesh.coarser();
    solid = mesh.solid();
    int[] array = new int[1];
    gl.glGenVertexArrays(1, array, 0);
    vertexArray = array[0];
    vertices = pool.take(gl);
    indices = pool.take(gl);
    gl.glBindVertexArray(vertexArray);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, vertices);
    gl.glBufferData(
        GL.GL_ARRAY_BUFFER, mesh.vertices().limit(), mesh.vertices(), GL.GL_STATIC_DRAW);
    gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, indices);
    gl.glBufferData(
        GL.GL_ELEMENT_ARRAY_BUFFER, mesh.indices().limit(), mesh.indices(), GL.GL_STATIC_DRAW);
    attributes(gl, mesh.layout());
    gl.glBindVertexArray(0);
  }

  private static void attributes(GL3 gl, VertexLayout layout) {
    attribute(gl, 0, 3, GL.GL_FLOAT, layout.stride(), 0);
    attribute(gl, 1, 3, GL.GL_SHORT, layout.stride(), layout.normal());
    attribute(gl, 2, 4, GL.GL_UNSIGNED_BYTE, layout.stride(), layout.color());
    attribute(gl, 3, 2, GL.GL_FLOAT, layout.stride(), layout.texCoord());
    int at = layout.stride();
    for (int i = layout.more().size() - 1; i >= 0; i--) {
      int size = layout.more().get(i);
      at -= 4 * size;
      attribute(gl, 4 + i, size, GL.GL_FLOAT, layout.stride(), at);
    }
  }

  private static void attribute(GL3 gl, int at, int size, int type, int stride, int offset) {
    if (offset >= 0) {
      gl.glEnableVertexAttribArray(at);
      gl.glVertexAttribPointer(at, size, type, type != GL.GL_FLOAT, stride, offset);
    }
  }

  public TriangleClusters clusters() {
    return clusters;
  }

  /** Returns the coarser refinement levels, fewest triangles first. */
  public List<RefinementLevelRange> coarser() {
    return coarser;
  }

  /** Returns the GL constant of the primitive type. */
  public int mode() {
    return mode;
  }

  /** Returns the GL constant of the index type. */
  public int indexType() {
    return indexType;
  }

  public int indexBytes() {
    return indexBytes;
  }

  public int indexCount() {
    return indexCount;
  }

  public boolean solid() {
    return solid;
  }

  public void bind(GL3 gl) {
    gl.glBindVertexArray(vertexArray);
  }

  public void dispose(GL3 gl) {
    gl.glDeleteVertexArrays(1, new int[] {vertexArray}, 0);
    pool.release(gl, vertices);
    pool.release(gl, indices);
  }
}
