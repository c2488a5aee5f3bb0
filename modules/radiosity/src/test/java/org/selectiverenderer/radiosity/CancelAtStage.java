package org.selectiverenderer.radiosity;

import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

/** Is cancelled as soon as the work comes to a stage. */
final class CancelAtStage implements RadiosityProgress {
  private final Stage end;
  private volatile boolean cancelled;

  CancelAtStage(Stage end) {
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
