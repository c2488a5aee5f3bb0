package org.selectiverenderer.app.window;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

/** Intercepts the closing of a window and runs an action instead. */
final class CloseInterceptor extends WindowAdapter {
  private final Runnable instead;

  CloseInterceptor(Runnable instead) {
    this.instead = instead;
  }

  @Override
  public void windowClosing(WindowEvent event) {
    instead.run();
  }
}
