package org.selectiverenderer.runtime.sai;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Holds back changes between {@code beginUpdate} and {@code endUpdate}, so that they take effect in
 * one frame. A bracket belongs to the thread that opens it: the controller, which answers on the
 * thread of the browser, does not wait for the brackets of others. Thread-safe.
 */
final class UpdateBuffer {
  private final ThreadLocal<@Nullable Held> open = new ThreadLocal<>();

  /** Opens a bracket unless there is one. */
  void begin() {
    if (open.get() == null) {
      open.set(new Held());
    }
  }

  /** Holds a change back; false when there is no bracket and it is to be done now. */
  boolean hold(Runnable change) {
    Held held = open.get();
    if (held != null) {
      held.changes.add(change);
    }
    return held != null;
  }

  /** Closes the bracket and returns what was held; nothing if there is none. */
  Held end() {
    Held held = open.get();
    open.remove();
    return held == null ? new Held() : held;
  }

  /** Changes in order; all are done, and then the first failure, if any, is thrown. */
  static final class Held implements Runnable {
    private final List<Runnable> changes = new ArrayList<>();

    boolean isEmpty() {
      return changes.isEmpty();
    }

    @Override
    public void run() {
      RuntimeException first = null;
      for (Runnable change : changes) {
        try {
          change.run();
        } catch (RuntimeException e) {
          if (first == null) {
            first = e;
          } else {
            first.addSuppressed(e);
          }
        }
      }
      if (first != null) {
        throw first;
      }
    }
  }
}
