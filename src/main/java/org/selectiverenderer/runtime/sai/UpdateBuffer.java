package org.selectiverenderer.runtime.sai;

import java.util.ArrayList;
import java.util.List;

/**
 * Holds back writes between {@code beginUpdate} and {@code endUpdate}, so that they take effect in
 * one frame. Thread-safe; there is one bracket for all threads, as the SAI has it.
 */
final class UpdateBuffer {
  private final List<Runnable> held = new ArrayList<>();
  private boolean open;

  synchronized void begin() {
    open = true;
  }

  /** Holds a write back; false when there is no bracket and it is to be done now. */
  synchronized boolean hold(Runnable write) {
    if (open) {
      held.add(write);
    }
    return open;
  }

  /** Closes the bracket and returns what was held, in order. */
  synchronized List<Runnable> end() {
    open = false;
    List<Runnable> writes = List.copyOf(held);
    held.clear();
    return writes;
  }
}
