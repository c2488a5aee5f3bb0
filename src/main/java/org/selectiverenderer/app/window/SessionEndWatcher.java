package org.selectiverenderer.app.window;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.function.BooleanSupplier;
import javax.swing.JFrame;
import javax.swing.Timer;

/**
 * Closes a participant's window when the session ends, and asks the experimenter when somebody else
 * closes it.
 *
 * @param over tells whether the session has ended
 * @param closing runs when somebody closes the window
 */
public record SessionEndWatcher(BooleanSupplier over, Runnable closing) {
  /** Polling interval in milliseconds. */
  private static final int LOOK = 200;

  /** Watches a window until it is disposed of. */
  void watch(JFrame frame, Runnable ended) {
    Timer watch =
        new Timer(
            LOOK,
            event -> {
              if (over.getAsBoolean()) {
                ended.run();
              }
            });
    frame.addWindowListener(new CloseInterceptor(closing));
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent event) {
            watch.stop();
          }
        });
    watch.start();
  }
}
