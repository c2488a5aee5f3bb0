package org.selectiverenderer.enricher.placement;

import java.util.ArrayList;
import java.util.List;

/** Holds what the handles of selected nodes do, and whether clicks measure, for all views. */
public final class HandleSettings {
  /** What the handles do. */
  public enum Mode {
    MOVE,
    TURN,
    SCALE
  }

  private final List<Runnable> listeners = new ArrayList<>();
  private Mode mode = Mode.MOVE;
  private boolean measuring;

  /** What the handles do. */
  public Mode mode() {
    return mode;
  }

  /** Sets what the handles do, and ends measuring. */
  public void use(Mode wanted) {
    mode = wanted;
    measuring = false;
    tell();
  }

  /** Whether clicks measure distances. */
  public boolean measuring() {
    return measuring;
  }

  /** Begins or ends measuring. */
  public void measure(boolean begin) {
    measuring = begin;
    tell();
  }

  private void tell() {
    listeners.forEach(Runnable::run);
  }

  /** Adds a listener for both. */
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }
}
