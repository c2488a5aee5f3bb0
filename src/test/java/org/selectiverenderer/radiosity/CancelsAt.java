package org.selectiverenderer.radiosity;

import org.selectiverenderer.radiosity.work.WorkProgress;

/** Is cancelled as soon as the work comes to a stage. */
final class CancelsAt implements WorkProgress {
  private final Stage end;
  private volatile boolean cancelled;

  CancelsAt(Stage end) {
    this.end = end;
  }

  @Override
  public void at(Stage stage, double share) {
    cancelled |= stage == end;
  }

  @Override
  public boolean cancelled() {
    return cancelled;
  }
}
