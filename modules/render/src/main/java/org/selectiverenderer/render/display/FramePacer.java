package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;

/** Limits the frames in flight: at most one frame is being drawn while the next is prepared. */
final class FramePacer {
  private static final long SECOND = 1_000_000_000L;

  private long previous;

  /** Waits until the previous frame is complete. */
  void await(GL3 gl) {
    if (previous != 0) {
      gl.glClientWaitSync(previous, 0, SECOND);
      gl.glDeleteSync(previous);
      previous = 0;
    }
  }

  /** Flushes the frame just submitted and waits for the one before it. */
  void submitted(GL3 gl) {
    long frame = gl.glFenceSync(GL3.GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.glFlush();
    await(gl);
    previous = frame;
  }
}
