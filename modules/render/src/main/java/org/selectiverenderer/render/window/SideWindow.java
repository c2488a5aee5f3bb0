package org.selectiverenderer.render.window;

import com.jogamp.newt.opengl.GLWindow;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLEventListener;
import java.util.Optional;

/** An open side window. Belongs to the render thread. */
final class SideWindow {
  private final SideWindowContent source;
  private final GLWindow window;
  private boolean started;
  private boolean stopping;
  private final Optional<InputListener> listener;
  private final InputQueue queue;
  private boolean drawn;

  /**
   * @param shared the main window's queue, for a side window without a listener of its own
   */
  SideWindow(SideWindowSpec side, InputQueue shared, Runnable onClose) {
    source = side.source();
    listener = side.input();
    queue = listener.isPresent() ? new InputQueue() : shared;
    window =
        NewtWindowFactory.create(
            side.options(),
            NewtWindowFactory.capabilities(side.options()),
            queue,
            onClose,
            new Drawing());
    NewtWindowFactory.show(window, side.options());
  }

  /** Delivers the input of this window to its own listener, if it has one. */
  void drain() {
    listener.ifPresent(queue::drain);
  }

  /** Draws new content without swapping the buffers yet. */
  void draw() {
    drawn = false;
    if (source.wanted()) {
      window.display();
    }
  }

  /** Swaps the buffers if something was drawn. */
  void swap() {
    if (drawn) {
      NewtWindowFactory.swap(window);
    }
  }

  void close() {
    stopping = true;
    NewtWindowFactory.close(window);
  }

  private final class Drawing implements GLEventListener {
    @Override
    public void init(GLAutoDrawable drawable) {
      // The main window waits for vertical synchronisation; waiting for a second display would
      // halve the frame rate.
      drawable.getGL().setSwapInterval(0);
    }

    @Override
    public void display(GLAutoDrawable drawable) {
      GL3 gl = drawable.getGL().getGL3();
      int width = drawable.getSurfaceWidth();
      int height = drawable.getSurfaceHeight();
      if (stopping) {
        stop(gl);
      } else if (width > 0 && height > 0) {
        started = true;
        gl.glViewport(0, 0, width, height);
        source.draw(gl, new FrameSize(width, height, NewtWindowFactory.scale(window)));
        drawn = true;
      }
    }

    private void stop(GL3 gl) {
      if (started) {
        started = false;
        source.stop(gl);
      }
    }

    @Override
    public void reshape(GLAutoDrawable drawable, int x, int y, int width, int height) {
      // Each frame asks for the size.
    }

    @Override
    public void dispose(GLAutoDrawable drawable) {
      stop(drawable.getGL().getGL3());
    }
  }
}
