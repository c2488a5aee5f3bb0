package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * The buffer objects of an owner of meshes that come and go. A buffer that is let go of loses its
 * data and is used again under its name: drivers may never give a deleted name again, and JOGL
 * keeps an entry for every name that there ever was, so that a long run would fill the heap.
 */
public final class BufferPool {
  private final Deque<Integer> free = new ArrayDeque<>();

  /** Returns the name of a buffer object without data. */
  int take(GL3 gl) {
    Integer name = free.poll();
    if (name != null) {
      return name;
    }
    int[] made = new int[1];
    gl.glGenBuffers(1, made, 0);
    return made[0];
  }

  /** Frees the data of a buffer object, which the next mesh may take. */
  void release(GL3 gl, int name) {
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, name);
    gl.glBufferData(GL.GL_ARRAY_BUFFER, 0, null, GL.GL_STATIC_DRAW);
    gl.glBindBuffer(GL.GL_ARRAY_BUFFER, 0);
    free.add(name);
  }

  /** Deletes the buffer objects that no mesh has. */
  public void dispose(GL3 gl) {
    for (int name : free) {
      gl.glDeleteBuffers(1, new int[] {name}, 0); // JOGL refuses an array of none.
    }
    free.clear();
  }
}
