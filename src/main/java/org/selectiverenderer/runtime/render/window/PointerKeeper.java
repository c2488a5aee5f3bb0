package org.selectiverenderer.runtime.render.window;

import com.jogamp.newt.opengl.GLWindow;

/**
 * Keeps the pointer in a window, unseen, while that is wanted. The window system may refuse, as
 * while the window is not yet on the screen or another program has the pointer; it is asked again.
 * Belongs to the render thread.
 */
final class PointerKeeper {
  /** Frames between two tries. */
  private static final int PATIENCE = 15;

  private final GLWindow window;
  private boolean kept;
  private int waiting;

  PointerKeeper(GLWindow window) {
    this.window = window;
  }

  /** Has it kept, or lets go of it. */
  void keep(boolean wanted) {
    if (wanted == kept) {
      return;
    }
    if (wanted && waiting > 0) {
      waiting--;
      return;
    }
    window.confinePointer(wanted);
    kept = window.isPointerConfined();
    window.setPointerVisible(!kept);
    if (kept) {
      window.requestFocus(false); // The keys that the experimenter is told of are heard here.
    }
    waiting = PATIENCE;
  }
}
