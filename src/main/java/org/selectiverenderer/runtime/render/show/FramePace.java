package org.selectiverenderer.runtime.render.show;

import com.jogamp.opengl.GL3;

/** Lets at most one frame be under way while the next is prepared. */
final class FramePace {
  private static final long SECOND = 1_000_000_000L;

  private long previous;

  /** Waits until the frame before is complete. */
  void await(GL3 gl) {
    if (previous != 0) {
      gl.glClientWaitSync(previous, 0, SECOND);
      gl.glDeleteSync(previous);
      previous = 0;
    }
  }

  /** A frame is submitted: waits for the one before it. */
  void submitted(GL3 gl) {
    long frame = gl.glFenceSync(GL3.GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.glFlush();
    await(gl);
    previous = frame;
  }
}
