package org.selectiverenderer.runtime.render.window;

import com.jogamp.newt.opengl.GLWindow;

/**
 * Confines the pointer to a window and hides it while that is wanted. The window system may refuse,
 * for example while the window is not mapped yet or another program has grabbed the pointer; then
 * it is asked again. Belongs to the render thread.
 */
final class PointerKeeper {
  /** Frames between two attempts. */
  private static final int PATIENCE = 15;

  private final GLWindow window;
  private boolean kept;
  private int waiting;

  PointerKeeper(GLWindow window) {
    this.window = window;
  }

  /** Confines or releases the pointer. */
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
      window.requestFocus(false); // This window hears the experimenter's keys.
    }
    waiting = PATIENCE;
  }
}
