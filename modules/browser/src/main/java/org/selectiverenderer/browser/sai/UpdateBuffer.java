package org.selectiverenderer.browser.sai;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Buffers changes between {@code beginUpdate} and {@code endUpdate}, so that they take effect in
 * one frame. A bracket belongs to the thread that opens it: the controller, which responds on the
 * browser's thread, is not delayed by the brackets of other threads. Thread-safe.
 */
final class UpdateBuffer {
  private final ThreadLocal<@Nullable Held> open = new ThreadLocal<>();

  /** Opens a bracket unless one is open. */
  void begin() {
    if (open.get() == null) {
      open.set(new Held());
    }
  }

  /** Buffers a change; returns false when no bracket is open and the change is to be done now. */
  boolean hold(Runnable change) {
    Held held = open.get();
    if (held != null) {
      held.changes.add(change);
    }
    return held != null;
  }

  /** Closes the bracket and returns the buffered changes; none if no bracket is open. */
  Held end() {
    Held held = open.get();
    open.remove();
    return held == null ? new Held() : held;
  }

  /** Buffered changes in order. All are executed; then the first failure, if any, is thrown. */
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
